// What every camera promises, held for each of them (pathtrace/cameras/camera_concept.h).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "pathtrace/cameras/camera_concept.h"
#include "pathtrace/cameras/eye_camera.h"
#include "pathtrace/cameras/general_camera.h"
#include "pathtrace/cameras/sharp_cells.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int width = 48, height = 32;

/// Looks along the world's x with z up: the wearer's right is −y.
CameraPose sideways_pose() {
  CameraPose pose;
  pose.position = {0.25, -0.5, 1.5};
  pose.look_at = pose.position + Vector3d(2.0, 0.0, 0.0);
  pose.up = {0.0, 0.0, 1.0};
  pose.vertical_field = 0.5;
  pose.width = width;
  pose.height = height;
  return pose;
}
const Vector3f right(0.0f, -1.0f, 0.0f), up(0.0f, 0.0f, 1.0f);

Eye astigmat(double pupil_mm, const Accommodation& accommodation = RelaxedAccommodation{}) {
  return Eye::with({-1.0, -2.0, 30.0}, pupil_mm * mm, accommodation);
}

Spectacles minus_lens(double diameter_mm = 60.0) {
  Spectacles lens;
  lens.front = SphereSurface{0.0};
  lens.back = SphereSurface{1.0 / 0.2};
  lens.center_thickness_m = 2 * mm;
  lens.diameter_m = diameter_mm * mm;
  return lens;
}

template <class C>
struct Specimen {
  const char* name;
  C camera;
  bool plain;  // nothing stands between the pupil and the scene, and the pupil does not turn
  double sideways_m = 0.0;
};

template <class C>
std::vector<Specimen<C>> specimens();

template <>
std::vector<Specimen<EyeCamera>> specimens() {
  const CameraPose pose = sideways_pose();
  const auto with = [&](RayModel model, const Eye& eye, double focus_m, CameraSkips skips = {}) {
    return EyeCamera(pose, EyeRays<float>(model, eye, 0.5, focus_m), std::move(skips));
  };
  auto half_sharp = std::make_shared<SharpCells>(width, height);
  half_sharp->blur({0.0, 0.0}, {width, 0.5 * height});
  const Eye eye = astigmat(6.0), pinhole = astigmat(0.0), at_the_pole = Eye::with({-2.0}, 6.0 * mm);
  return {{"power matrix", with(RayModel::power_matrix, eye, 2.0), true},
          {"sine squared", with(RayModel::sin2_radial, eye, 2.0), true},
          {"zernike", with(RayModel::zernike, eye, 2.0), true},
          {"metalstigmatism", with(RayModel::metalstigmatism, eye, 0.2), true},
          {"metalstigmatism at its pole", with(RayModel::metalstigmatism, at_the_pole, 0.5), false},
          {"pinhole", with(RayModel::pinhole, eye, 2.0), true},
          {"no pupil", with(RayModel::power_matrix, pinhole, 2.0), true},
          {"no pupil, points all the same", with(RayModel::power_matrix, pinhole, 2.0, {false, nullptr}), true},
          {"half sharp", with(RayModel::power_matrix, eye, 2.0, {true, half_sharp}), true}};
}

template <>
std::vector<Specimen<GeneralCamera>> specimens() {
  const CameraPose pose = sideways_pose();
  ViewOptions worn, rim_cut, polar, foveal, around;
  worn.spectacles = minus_lens();
  rim_cut.spectacles = minus_lens(8.0);
  polar.pupil = PupilSampler({PupilSampling::UniformPolarWeighted}, 0.5);
  polar.sideways_m = 0.03;
  foveal.spectacles = minus_lens();
  foveal.gaze = Gaze::Foveal;
  foveal.distance_along = [](const LightRay& ray) { return 0.4 + 0.1 * std::abs(ray.direction.y()); };
  around.projection = Projection::Equirectangular;
  return {
      {"naked", GeneralCamera(pose, astigmat(6.0), RayModel::power_matrix, {}), true},
      {"pinhole", GeneralCamera(pose, astigmat(6.0), RayModel::pinhole, {}), true},
      {"polar, weighted", GeneralCamera(pose, astigmat(6.0), RayModel::power_matrix, polar), true, polar.sideways_m},
      {"spectacles", GeneralCamera(pose, astigmat(6.0), RayModel::zernike, worn), false},
      {"cut by the rim", GeneralCamera(pose, astigmat(4.0), RayModel::power_matrix, rim_cut), false},
      {"foveal", GeneralCamera(pose, astigmat(6.0, BestAccommodation{6.0}), RayModel::power_matrix, foveal), false},
      {"all around", GeneralCamera(pose, astigmat(6.0), RayModel::power_matrix, around), false}};
}

PixelSequence sequence_of(int x, int y, Sequence kind = Sequence::Sobol) {
  return {kind, 11, static_cast<std::uint32_t>(y * width + x)};
}

Vector3f origin_of(const CameraRayBlock& block, int i) {
  return {block.origin[0][i], block.origin[1][i], block.origin[2][i]};
}
Vector3f direction_of(const CameraRayBlock& block, int i) {
  return {block.direction[0][i], block.direction[1][i], block.direction[2][i]};
}

template <class C>
struct CameraContract : ::testing::Test {};
using Cameras = ::testing::Types<EyeCamera, GeneralCamera>;
TYPED_TEST_SUITE(CameraContract, Cameras);

constexpr std::pair<int, int> some_pixels[] = {{24, 16}, {3, 2}, {45, 29}, {40, 5}};

TYPED_TEST(CameraContract, MeetsTheConcept) {
  static_assert(Camera<TypeParam>);
  for (const auto& [name, camera, plain, sideways_m] : specimens<TypeParam>()) {
    EXPECT_EQ(camera.width(), width) << name;
    EXPECT_EQ(camera.height(), height) << name;
  }
}

TYPED_TEST(CameraContract, APlaceIsThatOfItsPixelAndSampleAlone) {
  for (const auto& [name, camera, plain, sideways_m] : specimens<TypeParam>())
    for (const auto& [x, y] : some_pixels) {
      const PixelSequence sequence = sequence_of(x, y);
      std::vector<typename TypeParam::SamplePlace> places;
      for (std::uint32_t sample = 0; sample < 64; ++sample)
        places.push_back(camera.place_of(camera.pixel(x, y), sample, sequence));
      for (std::uint32_t sample = 64; sample-- > 0;) {  // asked again, in another order
        const auto again = camera.place_of(camera.pixel(x, y), sample, sequence_of(x, y));
        const auto& at = places[sample];
        EXPECT_EQ(again.film, at.film) << name;
        EXPECT_EQ(camera.pupil_point(again), camera.pupil_point(at)) << name;
        EXPECT_TRUE(at.film.x() >= x && at.film.x() <= x + 1 && at.film.y() >= y && at.film.y() <= y + 1)
            << name << ": " << at.film.transpose();
        EXPECT_LE(camera.pupil_point(at).norm(), static_cast<float>(camera.rays().pupil_radius()) * 1.000001f) << name;
        EXPECT_NE(places[(sample + 1) % 64].film, at.film) << name;
      }
    }
}

TYPED_TEST(CameraContract, EachRayOfABlockIsTheSingleRayOfItsPlace) {
  int gone_on = 0, stopped = 0;
  for (const auto& [name, camera, plain, sideways_m] : specimens<TypeParam>())
    for (const auto& [x, y] : some_pixels)
      for (const Sequence kind : {Sequence::Sobol, Sequence::Halton, Sequence::Independent})
        for (const std::uint32_t first : {0u, 5u}) {
          CameraRayBlock block;
          camera.generate(x, y, first, sequence_of(x, y, kind), block);
          for (int i = 0; i < CameraRayBlock::size; ++i) {
            const auto pixel = camera.pixel(x, y);
            const auto at = camera.place_of(pixel, first + static_cast<std::uint32_t>(i), sequence_of(x, y, kind));
            const CameraRay ray = camera.single(pixel, at);
            ASSERT_EQ(block.status[i], ray.status) << name << " " << i;
            (goes_on(ray.status) ? gone_on : stopped)++;
            if (!goes_on(ray.status)) continue;
            ASSERT_EQ(origin_of(block, i), ray.origin) << name << " " << i;
            ASSERT_EQ(direction_of(block, i), ray.direction) << name << " " << i;
          }
        }
  EXPECT_GT(gone_on, 2000);
  EXPECT_GT(stopped, 100);
}

TYPED_TEST(CameraContract, FartherRightAndDownOnTheFilmIsFartherRightAndDownInTheWorld) {
  for (const auto& [name, camera, plain, sideways_m] : specimens<TypeParam>())
    for (const auto& [x, y] : {std::pair(10, 6), std::pair(37, 6), std::pair(10, 25), std::pair(37, 25)}) {
      CameraRayBlock block;
      camera.generate(x, y, 0, sequence_of(x, y), block);
      for (int i = 0; i < CameraRayBlock::size; ++i) {
        if (!goes_on(block.status[i])) continue;
        // 9 px and more from the middle of the picture: 0.14, against 0.02 that the pupil's rays are bent by.
        EXPECT_GT(direction_of(block, i).dot(right) * (x < width / 2 ? -1.0f : 1.0f), 0.1f) << name;
        EXPECT_GT(direction_of(block, i).dot(up) * (y < height / 2 ? 1.0f : -1.0f), 0.1f) << name;
      }
    }
}

TYPED_TEST(CameraContract, APupilPointOnTheRightStartsOnTheRight) {
  float farthest_right = 0.0f, farthest_up = 0.0f;
  for (const auto& [name, camera, plain, sideways_m] : specimens<TypeParam>()) {
    if (!plain) continue;
    const int x = 24, y = 16;
    const auto pixel = camera.pixel(x, y);
    const PixelSequence sequence = sequence_of(x, y);
    const Vector3f middle = sideways_pose().position.cast<float>() + static_cast<float>(sideways_m) * right;
    for (std::uint32_t sample = 0; sample < 64; ++sample) {
      const auto at = camera.place_of(pixel, sample, sequence);
      const Vector3f start = camera.single(pixel, at).origin - middle;
      const Vector2f point = camera.pupil_point(at);
      EXPECT_NEAR(start.dot(right), point.x(), 2e-7f) << name;  // rounding of coordinates of about 1
      EXPECT_NEAR(start.dot(up), point.y(), 2e-7f) << name;
      farthest_right = std::max(farthest_right, point.x());
      farthest_up = std::max(farthest_up, point.y());
    }
  }
  EXPECT_GT(farthest_right, 2.0f * static_cast<float>(mm));
  EXPECT_GT(farthest_up, 2.0f * static_cast<float>(mm));
}

TYPED_TEST(CameraContract, WeightsHaveTheMeanOne) {
  if constexpr (TypeParam::weighted) {
    for (const auto& [name, camera, plain, sideways_m] : specimens<TypeParam>()) {
      double sum = 0.0;
      CameraRayBlock block;
      for (std::uint32_t first = 0; first < 4096; first += CameraRayBlock::size) {
        camera.generate(24, 16, first, sequence_of(24, 16), block);
        for (const float weight : block.weight) sum += static_cast<double>(weight);
      }
      EXPECT_NEAR(sum / 4096.0, 1.0, 2e-3) << name;  // 4096 stratified points
    }
  }
}

}  // namespace
}  // namespace sturm
