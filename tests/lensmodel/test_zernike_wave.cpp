// Zernike polynomials against tests/reference/zernike.json (50-digit arithmetic, prysm, POPPY, Optiland), and
// wavefronts: frames, signs, smaller pupils.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lensmodel/eye.h"
#include "support/quadrature.h"
#include "support/reference_file.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;
using testing::um;

/// Coefficients that are all zero but one.
std::vector<double> only(std::size_t j, double value) {
  std::vector<double> c(j + 1, 0.0);
  c[j] = value;
  return c;
}

TEST(Zernike, ValuesAndGradientsAreTheReferences) {
  const auto file = testing::reference_file("zernike.json");
  ASSERT_EQ(file["cases"].size(), 10u);
  for (const auto& c : file["cases"]) {
    const double x = c["inputs"]["x"], y = c["inputs"]["y"];
    for (int j = 0; j < 28; ++j) {
      const PlanePolynomial z = zernike_polynomial(j);
      // What the reference promises to a double-precision implementation; gradients are up to 82.
      EXPECT_NEAR(z(x, y), c["outputs"]["Z"][static_cast<std::size_t>(j)].get<double>(), 1e-12)
          << c["id"] << " j = " << j;
      EXPECT_NEAR(z.derivative_x()(x, y), c["outputs"]["dZdx"][static_cast<std::size_t>(j)].get<double>(), 1e-12)
          << c["id"] << " j = " << j;
      EXPECT_NEAR(z.derivative_y()(x, y), c["outputs"]["dZdy"][static_cast<std::size_t>(j)].get<double>(), 1e-12)
          << c["id"] << " j = " << j;
    }
  }
}

TEST(Zernike, TheSingleIndexIsItsOwnInverse) {
  const int expected[10][2] = {{0, 0}, {1, -1}, {1, 1}, {2, -2}, {2, 0}, {2, 2}, {3, -3}, {3, -1}, {3, 1}, {3, 3}};
  for (int j = 0; j < 10; ++j) {
    EXPECT_EQ(ZernikeIndex::of(j).n, expected[j][0]);
    EXPECT_EQ(ZernikeIndex::of(j).m, expected[j][1]);
  }
  for (int j = 0; j < 231; ++j) EXPECT_EQ(ZernikeIndex::of(j).single(), j);
}

TEST(ZernikeWave, AMyopesDefocusIsPositive) {
  // −1 D over 6 mm: c = −M a²/(4√3) = 9e-6/6.9282 = 1.29904 µm. The ray at the upper rim leaves downwards by 3 mrad: it
  // diverges as seen from the scene, so the scene must lie near.
  const auto wave = ZernikeWave::from_examiner(only(4, 1.2990381056766578 * um), 3 * mm);
  EXPECT_NEAR(wave.power(SecondOrder::LeastSquares).spherical_equivalent(), -1.0, 1e-12);
  EXPECT_NEAR(wave.slope({0.0, 3 * mm}).y(), -3e-3, 1e-15);
  EXPECT_NEAR(wave.slope({0.0, 3 * mm}).x(), 0.0, 1e-18);
}

TEST(ZernikeWave, Axis30IsNotAxis150) {
  // −1 D cylinder × 30 at the cornea: J0 = ½ cos 60° = 0.25, J45 = ½ sin 60° = 0.4330127, M = −0.5; the coefficients
  // over 3 mm of diameter are those of case E05 of tests/reference/wave_psf.json.
  const std::vector<double> c{
      0.0, 0.0, 0.0, -0.19887378220871652 * um, 0.16237976320958225 * um, -0.11481983169296153 * um};
  const PowerMatrix f = ZernikeWave::from_examiner(c, 1.5 * mm).power(SecondOrder::LeastSquares);
  const Prescription rx = f.as_prescription();
  EXPECT_NEAR(rx.sphere_D, 0.0, 1e-12);
  EXPECT_NEAR(rx.cylinder_D, -1.0, 1e-12);
  EXPECT_NEAR(rx.axis_deg, 30.0, 1e-10);
  EXPECT_NEAR(f.xy(), -0.4330127018922193, 1e-12);  // the wearer's sign
  auto mirrored = c;
  mirrored[3] = -mirrored[3];
  EXPECT_NEAR(
      ZernikeWave::from_examiner(mirrored, 1.5 * mm).power(SecondOrder::LeastSquares).as_prescription().axis_deg, 150.0,
      1e-10);
}

TEST(ZernikeWave, ComaFollowsTheExaminersX) {
  // Z(3,1) = √8 (3r³ − 2r) cos θ. In the middle its slope along the examiner's +x is −2√8 c/a, so W falls towards the
  // wearer's left, and the ray −∇W there goes to the wearer's … examiner's +x is the wearer's −x: slope = (−2√8 c/a, 0)
  // in the wearer frame.
  const double c = 0.3 * um, a = 3 * mm;
  const auto wave = ZernikeWave::from_examiner(only(8, c), a);
  EXPECT_NEAR(wave.slope({0.0, 0.0}).x(), -5.656854249492381 * c / a, 1e-18);
  EXPECT_NEAR(wave.slope({0.0, 0.0}).y(), 0.0, 1e-18);
  // Vertical coma keeps its sign: slope = −∂W/∂y = +2√8 c/a.
  EXPECT_NEAR(ZernikeWave::from_examiner(only(7, c), a).slope({0.0, 0.0}).y(), 5.656854249492381 * c / a, 1e-18);
}

TEST(ZernikeWave, AlongXItIsAPolynomial) {
  std::vector<double> c(28, 0.0);  // up to order 6, all of them
  for (std::size_t j = 0; j < c.size(); ++j) c[j] = 1e-7 * static_cast<double>(j % 5 + 1);
  const ZernikeWave wave = ZernikeWave::from_examiner(c, 3e-3);
  for (const double y : {-1.4e-3, 0.0, 2.1e-3}) {
    const std::vector<double> powers = wave.height_in_x(y / 3e-3);
    ASSERT_EQ(powers.size(), 7u);
    for (const double x : {-1.7e-3, 0.4e-3}) {
      double sum = 0.0;
      for (std::size_t i = 0; i < powers.size(); ++i) sum += powers[i] * std::pow(x / 3e-3, static_cast<double>(i));
      // Coefficients of order 6 reach 70 times a height; 28 sums in double.
      EXPECT_NEAR(sum, wave.height({x, y}), 1e-19) << x << ' ' << y;
    }
  }
}

TEST(ZernikeWave, OfAPowerIsItsParabola) {
  const PowerMatrix f = PowerMatrix::from({-2.0, -1.5, 30.0, 0.0});
  const auto wave = ZernikeWave::of_power(f, 2 * mm);
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(1 * mm, 0.5 * mm), Eigen::Vector2d(-1.2 * mm, 1.4 * mm)}) {
    EXPECT_LT((wave.slope(p) - f.slope(p)).norm(), 1e-16);
    EXPECT_NEAR(wave.height(p), -0.5 * p.dot(f.matrix() * p), 1e-20);
  }
  EXPECT_LT((wave.power(SecondOrder::LeastSquares).matrix() - f.matrix()).norm(), 1e-12);
  EXPECT_LT((wave.power(SecondOrder::Paraxial).matrix() - f.matrix()).norm(), 1e-12);
}

std::vector<double> some_coefficients() {
  std::vector<double> c;
  for (int j = 0; j < 36; ++j) c.push_back((j % 5 - 2) * 0.11 * um + (j % 3) * 0.07 * um);
  return c;
}

TEST(ZernikeWave, RescalingIsTheLeastSquaresFitOverTheSmallerPupil) {
  const auto wave = ZernikeWave::from_examiner(some_coefficients(), 3 * mm);
  for (const double radius : {2.9 * mm, 2 * mm, 0.7 * mm}) {
    const auto small = wave.rescaled(radius);
    // The least-squares coefficients over the disc are the projections ⟨W, Z_j⟩, by a quadrature that is exact for 7 +
    // 7 orders.
    std::vector<double> fit(36, 0.0);
    for (const auto& node : testing::gauss_legendre_unit(12))
      for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 24, x = std::sqrt(node.x) * std::cos(angle),
                     y = std::sqrt(node.x) * std::sin(angle);
        for (int j = 0; j < 36; ++j)
          fit[static_cast<std::size_t>(j)] +=
              node.weight / 24 * wave.height({radius * x, radius * y}) * zernike_polynomial(j)(x, y);
      }
    for (std::size_t j = 0; j < 36; ++j) EXPECT_NEAR(small.coefficients()[j], fit[j], 1e-18) << "j = " << j;
  }
  EXPECT_THROW(wave.rescaled(3.001 * mm), std::invalid_argument);
}

TEST(ZernikeWave, RaysOfASmallerPupilAreTheSameRays) {
  const auto wave = ZernikeWave::from_examiner(some_coefficients(), 3 * mm), small = wave.rescaled(2 * mm);
  const Eigen::Vector2d p(1.1 * mm, -0.8 * mm);
  EXPECT_LT((wave.slope(p) - small.slope(p)).norm(), 1e-15);
}

TEST(ZernikeWave, SphericalAberrationSeparatesTheTwoPowers) {
  // W = c√5 (6r⁴ − 6r² + 1): curvature −12√5 c/a² at the centre, so F = +12√5 c/a²; the nearest parabola over the whole
  // pupil is flat.
  const double c = 0.2 * um, a = 3 * mm;
  const auto wave = ZernikeWave::from_examiner(only(12, c), a);
  EXPECT_NEAR(wave.power(SecondOrder::LeastSquares).spherical_equivalent(), 0.0, 1e-15);
  EXPECT_NEAR(wave.power(SecondOrder::Paraxial).xx(), 26.832815729997478 * c / (a * a), 1e-13);
  // Over a vanishing pupil both are the same.
  EXPECT_NEAR(wave.rescaled(1e-4 * a).power(SecondOrder::LeastSquares).xx(), 26.832815729997478 * c / (a * a), 1e-8);
}

TEST(Eye, AWavefrontAndAPrescriptionAdd) {
  const auto wave = ZernikeWave::from_examiner(only(8, 0.3 * um), 3 * mm);
  const Prescription rx{-2.0, -1.0, 30.0, 0.0};
  const Eye eye = Eye::with(wave, SecondOrder::LeastSquares, rx, 6 * mm);
  EXPECT_LT((eye.correction.matrix() - PowerMatrix::from(rx).matrix()).norm(), 1e-12);
  const Eigen::Vector2d p(1 * mm, 2 * mm);
  EXPECT_LT((eye.wavefront->slope(p) - wave.slope(p) - PowerMatrix::from(rx).slope(p)).norm(), 1e-16);
  EXPECT_THROW(Eye::with(wave, SecondOrder::LeastSquares, {}, 6.1 * mm), std::invalid_argument);
  EXPECT_NO_THROW(Eye::with(wave, SecondOrder::LeastSquares, {}, 0.0));
}

}  // namespace
}  // namespace sturm
