// What the guide knows of a camera's rays: their conoid, their slopes over the pupil and the density of pupil points.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pathtrace/guide/view_cases.h"
#include "pathtrace/guide/view_guide.h"
#include "pathtrace/sampling/across.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector2d;
using testing::mm;

TEST(ViewConoid, RaysPassWhereItSays) {
  for (const testing::ViewCase& c : {testing::toric(), testing::progressive(), testing::focal_line()}) {
    const GeneralCamera camera(testing::view_pose(), c.eye, c.model, c.options());
    const PupilSlopes slopes = fitted_slopes(camera.rays());
    const ViewConoidField field(camera, slopes);
    const double film_x = 21.3, film_y = 9.8;  // between the corners
    const GeneralCamera::Sight sight = camera.sight_at(film_x, film_y);
    const auto chief = camera.leaving(sight, {0.0, 0.0, 0.0, 0.0, LaunchStatus::ok});
    ASSERT_TRUE(chief);
    const auto conoid = field.at(film_x, film_y);
    ASSERT_TRUE(conoid);
    const double distance = 2.0;
    for (const Vector2d& p :
         {Vector2d(2.1 * mm, 0.4 * mm), Vector2d(-0.7 * mm, 1.9 * mm), Vector2d(-1.5 * mm, -1.5 * mm)}) {
      const PupilRay<double> through = camera.rays().through(p.x(), p.y());
      const auto ray = camera.leaving(sight, through);
      ASSERT_TRUE(ray);
      const LightRay there{chief->at(distance), chief->direction};
      const Vector2d seen = offset_across(axes_across(*chief), there, *ray),
                     said = conoid->constant(distance) + conoid->by_point(distance) * p +
                            conoid->by_slope(distance) * Vector2d(through.sx, through.sy);
      // The residual was found with rays at the rim of the pupil, which are off most.
      EXPECT_LT((seen - said).norm(), conoid->offset_residual_m + distance * conoid->direction_residual + 1e-9)
          << c.name;
      EXPECT_LT(conoid->offset_residual_m + distance * conoid->direction_residual,
                c.largest_residual * 3 * mm * distance)
          << c.name;
    }
  }
}

TEST(PupilSlopes, OfSin2RaysByHand) {
  // s = P(φ) p with P = F₁cos² + F₂ sin² along the axes: 4 E[s pᵀ]/a² has (3F₁ + F₂)/4 and (F₁ + 3F₂)/4 on its
  // diagonal. AXIS 90 has the cylinder's power along x: F₁ = −4, F₂ = −1. The difference from it is a(F₁ − F₂)/4 at
  // most: along the axes, and between them.
  const PupilSlopes slopes =
      fitted_slopes(EyeRays<double>(RayModel::sin2_radial, Eye::with({-1.0, -3.0, 90.0, 0.0}, 6 * mm), 0.0));
  EXPECT_NEAR(slopes.matrix(0, 0), -3.25, 1e-12);
  EXPECT_NEAR(slopes.matrix(1, 1), -1.75, 1e-12);
  EXPECT_NEAR(slopes.matrix(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(slopes.constant.norm(), 0.0, 1e-15);
  EXPECT_NEAR(slopes.residual, 3 * mm * 0.75, 1e-12);
}

TEST(PupilSampler, DensityAndWeightAreThoseOfItsPoints) {
  // The mean of weight × f over the unit square is the integral of density × weight × f over the disc.
  const auto f = [](const Vector2d& p) {
    return 1.0 + p.x() * p.x() + 0.5 * p.y() + 2.0 * p.squaredNorm() * p.squaredNorm();
  };
  for (const PupilSampling kind :
       {PupilSampling::UniformDisk, PupilSampling::UniformPolar, PupilSampling::UniformPolarWeighted})
    for (const double apodization : {0.0, 1.04}) {
      const PupilSampler sampler({kind}, apodization);
      constexpr int n = 400;
      double points = 0.0, integral = 0.0, total = 0.0;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double u = (i + 0.5) / n, v = (j + 0.5) / n, angle = 2.0 * std::numbers::pi * v;
          const WeightedPoint at = sampler.at(u, v);
          EXPECT_NEAR(sampler.weight(at.point), at.weight, 1e-12 * at.weight);
          points += at.weight * f(at.point) / (n * n);
          const Vector2d p = u * Vector2d(std::cos(angle), std::sin(angle));  // dA = 2π u du dv
          const double share = 2.0 * std::numbers::pi * u * sampler.density(p) / (n * n);
          integral += share * sampler.weight(p) * f(p);
          total += share;
        }
      EXPECT_NEAR(total, 1.0, 1e-5);  // midpoint rule, O(1/n²)
      EXPECT_NEAR(points, integral, 1e-4);
    }
}

}  // namespace
}  // namespace sturm
