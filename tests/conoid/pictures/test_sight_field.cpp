#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "conoid/pictures/sight_field.h"
#include "lensmodel/gaze.h"
#include "lensmodel/spectacles.h"

namespace sturm {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

PicturePlane plane(Gaze gaze) {
  PicturePlane p;
  p.position = {0.1, 1.2, -0.3};
  p.world_from_head = Eigen::AngleAxisd(0.4, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  p.width = 200;
  p.height = 120;
  p.pixel_slope = 5e-3;
  p.gaze = gaze;
  return p;
}

Eye astigmat(double axis) {
  return Eye::with(Prescription{-1.0, -2.0, axis, 0.0}, 4e-3);
}

Spectacles toric_lens() {
  Spectacles lens;
  lens.front = SphereSurface{4.0};
  lens.back = TorusSurface(9.0, 12.0, 30.0);
  lens.center_thickness_m = 2.5e-3;
  lens.refractive_index = 1.6;
  return lens;
}

/// The ray of a place through a pupil point by Snell's law at both surfaces: no conoid in it.
LightRay real_ray(const PicturePlane& p, const Eye& eye, const Spectacles* lens, const Vector2d& place,
                  const Vector2d& pupil) {
  const Vector2d q = p.slope(place);
  const Matrix2d s = eye.correction.matrix();
  LightRay ray;
  if (p.gaze == Gaze::Camera) {
    const Vector2d slope = q + s * pupil;
    ray = {{pupil.x(), pupil.y(), 0.0}, Vector3d(slope.x(), slope.y(), -1.0).normalized()};
  } else {
    const Vector3d gaze = Vector3d(q.x(), q.y(), -1.0).normalized();
    const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
    const Vector2d slope = s * pupil;
    ray = {turned_pupil_center(gaze, eye.rotation_center_m) + turn * Vector3d(pupil.x(), pupil.y(), 0.0),
           (turn * Vector3d(slope.x(), slope.y(), -1.0)).normalized()};
  }
  if (lens) ray = trace(*lens, ray).exit;
  return {p.position + p.world_from_head * ray.origin, p.world_from_head * ray.direction};
}

/// Distance of a point from a ray's line.
double off_line(const LightRay& ray, const Vector3d& point) {
  return (point - ray.origin).cross(ray.direction.normalized()).norm();
}

struct Setting {
  Gaze gaze;
  bool lens;
};

class Sights : public ::testing::TestWithParam<Setting> {
 protected:
  PicturePlane plane_ = plane(GetParam().gaze);
  Eye eye_ = astigmat(30.0);
  Spectacles lens_ = toric_lens();
  const Spectacles* worn() const { return GetParam().lens ? &lens_ : nullptr; }
  SightField field() const { return {plane_, eye_, GetParam().lens ? std::optional(lens_) : std::nullopt}; }
};

TEST_P(Sights, AreTheRealRaysToFirstOrderInThePupil) {
  const SightField f = field();
  for (const Vector2d& place : {Vector2d(100.0, 60.0), Vector2d(33.0, 20.5), Vector2d(180.2, 110.7)}) {
    const Sight sight = f.at(place);
    const auto offsets = sight.offsets(eye_.correction.matrix()),
               directions = sight.directions(eye_.correction.matrix());
    for (const double t : {0.3, 2.0}) {
      const Vector3d target = sight.origin + t * sight.direction;
      const double grid =
          GetParam().lens ? 2e-5 * (0.05 + t) : 1e-9;  // of the chief ray: what the field's docstring says
      EXPECT_LT(off_line(real_ray(plane_, eye_, worn(), place, {0.0, 0.0}), target), grid) << place.transpose();
      for (const Vector2d& p : {Vector2d(1e-4, 0.0), Vector2d(0.0, 1e-4), Vector2d(-0.7e-4, 0.5e-4)}) {
        // Half the difference of the real rays through p and −p where they pass the plane across the chief ray: free of
        // p². What is left is the grid's 1e-3 of the maps, and p³.
        const auto crossing = [&](const Vector2d& q) -> Vector3d {
          const LightRay ray = real_ray(plane_, eye_, worn(), place, q);
          return ray.origin +
                 (target - ray.origin).dot(sight.direction) / ray.direction.dot(sight.direction) * ray.direction;
        };
        const Vector3d real = 0.5 * (crossing(p) - crossing(-p));
        Vector3d first = offsets * p + t * (directions * p);
        first -= first.dot(sight.direction) / sight.direction.squaredNorm() * sight.direction;
        EXPECT_LT((real - first).norm(), (GetParam().lens ? 1e-3 : 1e-6) * 1e-4 * (1.0 + 3.0 * t)) << place.transpose();
      }
    }
  }
}

TEST_P(Sights, TheMapSaysWhereAPupilPointSeesAPoint) {
  const SightField f = field();
  const Vector2d place(140.0, 30.0);
  const Sight sight = f.at(place);
  const SightNeighbourhood around(f, place, sight);
  for (const double t : {0.4, 3.0}) {
    const Vector3d target = sight.origin + t * sight.direction;
    const Matrix2d map = around.picture_map(eye_.correction.matrix(), 1.0 / t);
    for (const Vector2d& p : {Vector2d(2e-4, 0.0), Vector2d(-1e-4, 1.5e-4)}) {
      const Vector2d seen = place + map * p;
      // Second order: p² against p · a pixel's worth of change. 2e-4 m · 2 D = 4e-4 rad of displacement, 1 % of it
      // left.
      const LightRay ray = real_ray(plane_, eye_, worn(), seen, p);
      EXPECT_LT(off_line(ray, target) / t, 0.01 * plane_.pixel_slope * (map * p).norm() + (worn() ? 2e-5 : 2e-6))
          << t;  // the grid's
      EXPECT_GT((map * p).norm(), 0.02);
    }
  }
}

TEST_P(Sights, PlaceOfFindsTheChiefRayThroughAPoint) {
  const SightField f = field();
  const Vector2d center(80.0, 50.0);
  const SightNeighbourhood around(f, center, f.at(center));
  for (const Vector2d& place : {Vector2d(80.3, 50.9), Vector2d(95.0, 35.0), Vector2d(60.0, 80.0)}) {
    const auto chief = f.chief_ray(place);
    ASSERT_TRUE(chief);
    const auto found = around.place_of(chief->origin + 0.7 * chief->direction);
    ASSERT_TRUE(found);
    EXPECT_LT((*found - place).norm(), 2e-3);  // what place_of promises, a tenth of its last step
  }
}

INSTANTIATE_TEST_SUITE_P(Eyes, Sights,
                         ::testing::Values(Setting{Gaze::Camera, false}, Setting{Gaze::Foveal, false},
                                           Setting{Gaze::Camera, true}, Setting{Gaze::Foveal, true}));

TEST(SightField, NakedEyeInCameraGazeHasTheMapOfItsVergence) {
  const SightField f(plane(Gaze::Camera), astigmat(30.0), std::nullopt);
  const Vector2d place(20.0, 100.0);
  const Matrix2d map = SightNeighbourhood(f, place, f.at(place)).picture_map(astigmat(30.0).correction.matrix(), 1.0);
  // V = 1 − 1 − 2 u uᵀ, u across the wearer's 150°: at 60° (u_x = 0.5, u_y = 0.8660254). −V in px, y down: 1 px = 5e-3.
  EXPECT_NEAR(map(0, 0), 100.0, 1e-6);
  EXPECT_NEAR(map(0, 1), 173.2050808, 1e-6);
  EXPECT_NEAR(map(1, 0), -173.2050808, 1e-6);
  EXPECT_NEAR(map(1, 1), -300.0, 1e-6);
}

TEST(SightField, Axis30AndAxis150AreMirrorImages) {
  const auto cross = [](double axis) {
    const SightField f(plane(Gaze::Foveal), astigmat(axis), std::nullopt);
    const Vector2d place(100.0, 60.0);
    return SightNeighbourhood(f, place, f.at(place)).picture_map(astigmat(axis).correction.matrix(), 1.0)(0, 1);
  };
  EXPECT_GT(cross(30.0), 100.0);
  EXPECT_NEAR(cross(30.0), -cross(150.0), 1e-6);
}

TEST(SightField, FovealFootprintsGoThroughTheJacobianOfTheProjection) {
  // Straight to the right at tan 50°: sec² 50° = 2.4203 along the radius, sec 50° = 1.5557 across. A point at 1/t is 1
  // + R/t further from the centre of rotation than from the pupil, in units of t.
  PicturePlane p = plane(Gaze::Foveal);
  const Eye eye = Eye::with(Prescription{-2.0, 0.0, 180.0, 0.0}, 4e-3);
  const SightField f(p, eye, std::nullopt);
  const Vector2d place(100.0 + 1.1917536 / 5e-3, 60.0);
  const Matrix2d map = SightNeighbourhood(f, place, f.at(place)).picture_map(eye.correction.matrix(), 0.5);
  const double angular = -(0.5 - 2.0) / (1.0 + 13.5e-3 * 0.5) / 5e-3;
  EXPECT_NEAR(map(0, 0) / angular, 2.4203, 2e-4);  // central differences over a pixel: (5e-3)²
  EXPECT_NEAR(-map(1, 1) / angular, 1.5557, 2e-4);
}

}  // namespace
}  // namespace sturm
