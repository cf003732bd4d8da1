// Second moments of the ray bundles of the two models of astigmatism, by quadrature over the pupil, against closed
// forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lensmodel/ellipse.h"
#include "lensmodel/symmetric2.h"
#include "pathtrace/cameras/ray_model.h"
#include "support/quadrature.h"
#include "support/reference_file.h"

namespace sturm {
namespace {

/// Covariance [rad²] of the directions in which a point at vergence 1/d is seen: x(d)/d = p/d + s(p), up to its sign.
Eigen::Matrix2d angular_covariance(RayModel model, const Eye& eye, double accommodation, double vergence) {
  const EyeRays<double> rays(model, eye, accommodation);
  // Quadratic in p times trigonometric degree 6: 4 × 16 nodes are exact.
  return testing::covariance_over_disc(eye.pupil_radius_m, 4, 16, [&](const Eigen::Vector2d& p) {
    const auto ray = rays.through(p.x(), p.y());
    return Eigen::Vector2d(vergence * p + Eigen::Vector2d(ray.sx, ray.sy));
  });
}

struct Case {
  Prescription rx;
  double accommodation, vergence;
};

const Case cases[] = {{{-1.0, -2.0, 30.0, 0.0}, 0.0, 1.0},   {{-1.0, -2.0, 150.0, 0.0}, 0.0, 2.0},
                      {{2.5, -1.25, 12.0, 0.0}, 1.5, 0.25},  {{0.0, 3.0, 77.0, 0.0}, 0.5, 0.0},
                      {{-4.75, -3.5, 115.0, 0.0}, 2.0, 4.0}, {{-3.0, 0.0, 180.0, 0.0}, 0.0, 0.5},
                      {{-1.0, -2.0, 180.0, 0.0}, 0.0, 3.0},  {{0.25, -0.25, 45.0, 0.0}, 0.0, 1.0}};

/// docs/theory.md#61-second-moments-in-closed-form, rotated from the principal directions of V into the wearer frame.
Eigen::Matrix2d closed_form(const Case& c, double radius, double (*along)(double, double)) {
  const double alpha = std::numbers::pi - c.rx.axis_deg * std::numbers::pi / 180.0;
  const Eigen::Vector2d axis(std::cos(alpha), std::sin(alpha)), across(-axis.y(), axis.x());
  const double v1 = c.vergence + c.rx.sphere_D - c.accommodation, v2 = v1 + c.rx.cylinder_D;
  return 0.25 * radius * radius *
         (along(v1, v2) * axis * axis.transpose() + along(v2, v1) * across * across.transpose());
}

double wavefront_moment(double v, double) {
  return v * v;
}
double sin2_moment(double v, double other) {
  return (5.0 * v * v + 2.0 * v * other + other * other) / 8.0;
}

void expect_close(const Eigen::Matrix2d& actual, const Eigen::Matrix2d& expected, double relative,
                  const std::string& what) {
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), relative * expected.norm()) << what << "\n"
                                                                                   << actual << "\nexpected\n"
                                                                                   << expected;
}

TEST(SecondMoments, BothModelsMeetTheirClosedForms) {
  for (const Case& c : cases) {
    const Eye eye = Eye::with(c.rx, 5e-3);
    const std::string what =
        std::to_string(c.rx.sphere_D) + " " + std::to_string(c.rx.cylinder_D) + " x " + std::to_string(c.rx.axis_deg);
    const Eigen::Matrix2d wave = angular_covariance(RayModel::power_matrix, eye, c.accommodation, c.vergence);
    const Eigen::Matrix2d sin2 = angular_covariance(RayModel::sin2_radial, eye, c.accommodation, c.vergence);
    expect_close(wave, closed_form(c, 2.5e-3, wavefront_moment), 1e-12, what);
    expect_close(sin2, closed_form(c, 2.5e-3, sin2_moment), 1e-12, what);
    // The total variance of sin² is too small by a²C²/16.
    EXPECT_NEAR(wave.trace() - sin2.trace(), std::pow(2.5e-3 * c.rx.cylinder_D, 2) / 16.0, 1e-12 * wave.trace() + 1e-22)
        << what;
  }
}

TEST(SecondMoments, AtAFocalLineSin2IsTooShortAndTooWide) {
  // −1.00 −2.00 × 30 at 1 m: V = 0 along the axis, −2 D across it.
  const Eye eye = Eye::with({-1.0, -2.0, 30.0, 0.0}, 4e-3);
  const Ellipse wave = Ellipse::of_second_moments(angular_covariance(RayModel::power_matrix, eye, 0.0, 1.0));
  const Ellipse sin2 = Ellipse::of_second_moments(angular_covariance(RayModel::sin2_radial, eye, 0.0, 1.0));
  EXPECT_NEAR(wave.semi_major, 4e-3, 1e-15);
  EXPECT_NEAR(*wave.orientation_deg, 60.0, 1e-9);
  EXPECT_NEAR(sin2.semi_major / wave.semi_major, 0.79056941504209483, 1e-12);  // √(5/8)
  EXPECT_NEAR(sin2.semi_minor / wave.semi_major, 0.35355339059327379, 1e-12);  // √(1/8)
  EXPECT_NEAR(*sin2.orientation_deg, 60.0, 1e-9);
}

TEST(SecondMoments, AtTheCircleOfLeastConfusionSin2IsTooSmall) {
  const Eye eye = Eye::with({-1.0, -2.0, 30.0, 0.0}, 4e-3);
  const Ellipse wave = Ellipse::of_second_moments(angular_covariance(RayModel::power_matrix, eye, 0.0, 2.0));
  const Ellipse sin2 = Ellipse::of_second_moments(angular_covariance(RayModel::sin2_radial, eye, 0.0, 2.0));
  EXPECT_NEAR(wave.semi_major, 2e-3, 1e-15);
  EXPECT_NEAR(sin2.semi_major, 2e-3 * 0.70710678118654752, 1e-12 * 2e-3);
  EXPECT_NEAR(sin2.semi_minor, 2e-3 * 0.70710678118654752, 1e-12 * 2e-3);
}

// 150 cases of an independent computation; examiner's frame, so xy changes sign.
TEST(SecondMoments, AgreeWithTheReferenceData) {
  const nlohmann::json file = testing::reference_file("naked_eye_blur.json");
  ASSERT_EQ(file["cases"].size(), 150u);
  for (const auto& c : file["cases"]) {
    const auto& in = c["inputs"];
    const Eye eye = Eye::with({in["S"], in["C"], in["A"], 0.0}, 1e-3 * in["pupil_mm"].get<double>());
    const double vergence = in["object_distance_m"].is_string() ? 0.0 : 1.0 / in["object_distance_m"].get<double>();
    const auto matrix = [](const nlohmann::json& m) {
      return Eigen::Matrix2d(
          (Eigen::Matrix2d() << m[0].get<double>(), -m[1].get<double>(), -m[1].get<double>(), m[2].get<double>())
              .finished());
    };
    // Relative to the blur or, where it nearly vanishes, to the rounding of vergences of up to 30 D: (a · 30 D ·
    // 1e−15)².
    const auto check = [&](RayModel model, const nlohmann::json& expected) {
      const Eigen::Matrix2d actual = angular_covariance(model, eye, 0.0, vergence), wanted = matrix(expected);
      EXPECT_LE((actual - wanted).cwiseAbs().maxCoeff(), 1e-12 * wanted.norm() + 1e-28)
          << c["id"] << " " << name_of(model);
    };
    check(RayModel::power_matrix, c["outputs"]["cov_rad2_xx_xy_yy"]);
    check(RayModel::sin2_radial, c["outputs"]["sin2_radial"]["cov_rad2_xx_xy_yy"]);
  }
}

}  // namespace
}  // namespace sturm
