#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/cameras/general_camera.h"
#include "pathtrace/film/render.h"
#include "support/replicates.h"
#include "support/scenes.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;

constexpr double float_rounding = 3e-7;  // of coordinates of about 1

CameraPose straight_pose(int width, int height, double half_slope) {
  CameraPose pose;
  pose.vertical_field = 2.0 * std::atan(half_slope);
  pose.width = width;
  pose.height = height;
  return pose;
}

Eye emmetrope(double pupil_mm, const Accommodation& accommodation = RelaxedAccommodation{}) {
  return Eye::with({}, pupil_mm * mm, accommodation);
}

/// A symmetric lens of +4 D, 12 mm before the pupil.
Spectacles plus_lens() {
  Spectacles lens;
  lens.front = SphereSurface{1.0 / 0.25};
  lens.back = SphereSurface{-1.0 / 0.25};
  lens.center_thickness_m = 4 * mm;
  return lens;
}

LightRay ray_of(const CameraRayBlock& block, int i) {
  const Eigen::Vector3d o(block.origin[0][i], block.origin[1][i], block.origin[2][i]);
  const Eigen::Vector3d d(block.direction[0][i], block.direction[1][i], block.direction[2][i]);
  return {o, d};
}

CameraRayBlock block_of(const auto& camera, int x, int y, std::uint64_t seed = 1) {
  CameraRayBlock block;
  camera.generate(x, y, 0, PixelSequence(Sequence::Sobol, seed, static_cast<std::uint32_t>(y * camera.width() + x)),
                  block);
  return block;
}

TEST(GeneralCamera, WithoutAnythingItIsTheEyeCamera) {
  CameraPose pose = straight_pose(32, 24, 0.4);
  pose.position = {0.1, 0.2, 0.3};
  pose.look_at = {-0.5, 0.4, 1.0};
  const Eye eye = Eye::with({-2.0, -1.5, 30.0}, 6 * mm, FixedAccommodation{0.5, 0.0});
  for (RayModel model : {RayModel::pinhole, RayModel::power_matrix, RayModel::sin2_radial, RayModel::zernike}) {
    const EyeCamera fast(pose, EyeRays<float>(model, eye, 0.5));
    const GeneralCamera view(pose, eye, model, {});
    const auto a = block_of(fast, 5, 20), b = block_of(view, 5, 20);
    for (int i = 0; i < CameraRayBlock::size; ++i) {
      EXPECT_LT((ray_of(a, i).origin - ray_of(b, i).origin).norm(), float_rounding);
      EXPECT_LT((ray_of(a, i).direction - ray_of(b, i).direction).norm(), 5.0 * float_rounding);
      EXPECT_EQ(b.status[i], LaunchStatus::ok);
      EXPECT_EQ(b.weight[i], 1.0f);
    }
  }
}

TEST(GeneralCamera, RaysGoThroughTheLensAsTheyAreTraced) {
  const CameraPose pose = straight_pose(16, 16, 0.5);
  const Eye eye = emmetrope(6.0);
  ViewOptions options;
  options.spectacles = plus_lens();
  const auto naked = block_of(GeneralCamera(pose, eye, RayModel::power_matrix, {}), 13, 4),
             worn = block_of(GeneralCamera(pose, eye, RayModel::power_matrix, options), 13, 4);
  for (int i = 0; i < CameraRayBlock::size; ++i) {
    const LightRay before{ray_of(naked, i).origin, ray_of(naked, i).direction.normalized()};
    const LensPath path = trace(plus_lens(), before);
    ASSERT_EQ(path.status, LensStatus::ok);
    EXPECT_LT((ray_of(worn, i).origin - path.exit.origin).norm(), float_rounding);
    EXPECT_LT((ray_of(worn, i).direction + path.exit.direction / path.exit.direction.z()).norm(), 5.0 * float_rounding);
    EXPECT_NEAR(ray_of(worn, i).direction.z(), -1.0, float_rounding);  // one unit of t is one metre of planar distance
  }
}

TEST(GeneralCamera, APlusLensMagnifies) {
  // What is seen 0.3 to the right lies nearer to the axis than without the lens: rays are bent towards it.
  const CameraPose pose = straight_pose(16, 16, 0.4);
  ViewOptions options;
  options.spectacles = plus_lens();
  const auto block = block_of(GeneralCamera(pose, emmetrope(0.0), RayModel::pinhole, options), 14, 8);
  EXPECT_GT(ray_of(block, 0).direction.x(), 0.2);
  EXPECT_LT(ray_of(block, 0).direction.x(), 0.32);  // the pixel's middle is at 0.325
}

/// A white room that shines alike from everywhere: what arrives is the share of rays that are not lost.
TEST(GeneralCamera, WhatTheRimStopsIsBlackAndCounted) {
  SceneDescription description;
  description.materials = {testing::lambertian(Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones())};
  description.meshes = testing::room(1.0f, 0);
  const Scene scene(description);
  const CameraPose pose = straight_pose(32, 32, 1.0);
  Spectacles small = plus_lens();
  small.diameter_m =
      16 * mm;  // seen from the pupil its back rim stands at a slope of 8/12 and a little less for the sag
  ViewOptions options;
  options.spectacles = small;
  RenderSettings settings;
  settings.samples_per_pixel = 16;
  settings.max_bounces = 0;
  const RenderResult result = render(scene, GeneralCamera(pose, emmetrope(0.0), RayModel::pinhole, options), settings);
  const double launched = 32.0 * 32.0 * 16.0, lost = static_cast<double>(result.counters.camera.lost_rim);
  EXPECT_EQ(result.counters.camera.launched, 32u * 32u * 16u);
  EXPECT_GT(lost / launched, 0.5);
  EXPECT_EQ(result.counters.camera.dropped, 0u);
  EXPECT_NEAR(testing::image_mean(result.radiance, 0), 1.0 - lost / launched, 1e-6);
  EXPECT_EQ(result.radiance.at(0, 0)[0], 0.0f);
  EXPECT_EQ(result.radiance.at(16, 16)[0], 1.0f);
}

TEST(GeneralCamera, WhatTheRimStopsIsBlackBeforeAnEnvironmentToo) {
  // Rays that the rim had stopped used to bring the sky behind it, and weights of the pupil were left out of it.
  SceneDescription description;
  description.materials = {testing::lambertian(Eigen::Vector3f::Zero())};
  description.spheres = {{{0.0f, 0.0f, 5.0f}, 0.1f, 0}};  // behind the eye: a scene has a surface
  description.environment = Environment{Eigen::Vector3f::Ones(), nullptr, 0.0f};
  const Scene scene(description);
  Spectacles small = plus_lens();
  small.diameter_m = 16 * mm;
  ViewOptions options;
  options.spectacles = small;
  RenderSettings settings;
  settings.samples_per_pixel = 16;
  settings.max_bounces = 0;
  const RenderResult result =
      render(scene, GeneralCamera(straight_pose(32, 32, 1.0), emmetrope(0.0), RayModel::pinhole, options), settings);
  const double launched = 32.0 * 32.0 * 16.0, lost = static_cast<double>(result.counters.camera.lost_rim);
  EXPECT_GT(lost / launched, 0.5);
  EXPECT_NEAR(testing::image_mean(result.radiance, 0), 1.0 - lost / launched, 1e-6);
  // The points of a weighted polar pupil weigh 2r/a: of single samples the mean is 1 and the variance that of u ↦ 2u,
  // 1/3.
  ViewOptions polar;
  polar.pupil = PupilSampler({PupilSampling::UniformPolarWeighted}, 0.0);
  settings.samples_per_pixel = 4096;
  const RenderResult weighted =
      render(scene, GeneralCamera(straight_pose(1, 1, 0.1), emmetrope(6.0), RayModel::power_matrix, polar), settings);
  EXPECT_NEAR(weighted.radiance.at(0, 0)[0], 1.0, 1e-3);
  EXPECT_NEAR(weighted.variance.at(0, 0)[0], 1.0 / 3.0, 1e-2);  // low-discrepancy points: far below 4σ of random ones
}

TEST(GeneralCamera, ApodizationKeepsTheMeanAndNarrowsTheBlur) {
  SceneDescription description;
  description.materials = {testing::lambertian(Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones())};
  description.meshes = testing::room(1.0f, 0);
  const Scene scene(description);
  RenderSettings settings;
  settings.samples_per_pixel = 256;
  settings.max_bounces = 0;
  for (PupilSampling kind : {PupilSampling::UniformDisk, PupilSampling::UniformPolar,
                             PupilSampling::UniformPolarWeighted, PupilSampling::Rings}) {
    ViewOptions options;
    options.pupil = PupilSampler({kind, 8, 6}, 1.0);
    const RenderResult result = render(
        scene, GeneralCamera(straight_pose(4, 4, 0.1), emmetrope(6.0), RayModel::power_matrix, options), settings);
    EXPECT_NEAR(testing::image_mean(result.radiance, 0), 1.0, 2e-3);  // weights by 4096 stratified points
  }
}

TEST(GeneralCamera, AnEquirectangularPictureIsTheWholeSphere) {
  CameraPose pose = straight_pose(360, 180, 1.0);
  ViewOptions options;
  options.projection = Projection::Equirectangular;
  const GeneralCamera camera(pose, emmetrope(6.0), RayModel::pinhole, options);
  const auto direction = [&](int x, int y) { return ray_of(block_of(camera, x, y), 0).direction; };
  constexpr double pixel = 1.5 * std::numbers::pi / 180.0;
  EXPECT_LT((direction(180, 90) - Eigen::Vector3d(0, 0, -1)).norm(), pixel);
  EXPECT_LT((direction(270, 90) - Eigen::Vector3d(1, 0, 0)).norm(), pixel);  // a quarter turn to the right
  EXPECT_LT((direction(90, 90) - Eigen::Vector3d(-1, 0, 0)).norm(), pixel);
  EXPECT_LT((direction(0, 90) - Eigen::Vector3d(0, 0, 1)).norm(), pixel);
  EXPECT_LT((direction(10, 0) - Eigen::Vector3d(0, 1, 0)).norm(), pixel);  // up
  EXPECT_LT((direction(10, 179) - Eigen::Vector3d(0, -1, 0)).norm(), pixel);
}

TEST(GeneralCamera, AnEquirectangularEyeIsFocusedAllRound) {
  // An emmetrope focused at 0.5 m: the rays of one direction meet there. With a pixel of 0.01° its rays are one bundle.
  const Eye eye = emmetrope(6.0, FixedAccommodation{2.0, 0.5});
  ViewOptions options;
  options.projection = Projection::Equirectangular;
  const GeneralCamera camera(straight_pose(36000, 18000, 1.0), eye, RayModel::power_matrix, options);
  for (const auto& [x, y] : {std::pair(20000, 9000), std::pair(31000, 3000), std::pair(5000, 14000)}) {
    const auto block = block_of(camera, x, y);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int i = 0; i < 16; ++i) mean += ray_of(block, i).origin + 0.5 * ray_of(block, i).direction;
    mean /= 16;
    for (int i = 0; i < 16; ++i) {
      const LightRay ray = ray_of(block, i);
      EXPECT_GT(ray.origin.norm(), 0.1 * mm);
      // 0.5 m · 0.01° = 0.09 mm of pixel; the cosine of the rays' 6 mrad moves the end by 9 µm.
      EXPECT_LT((ray.origin + 0.5 * ray.direction - mean).norm(), 0.12 * mm);
    }
  }
}

ViewOptions foveal(double distance) {
  ViewOptions options;
  options.gaze = Gaze::Foveal;
  options.distance_along = [distance](const LightRay&) { return distance; };
  return options;
}

TEST(GeneralCamera, AFovealEyeTurnsAndAccommodates) {
  const Eye eye = emmetrope(6.0, BestAccommodation{5.0});
  const GeneralCamera camera(straight_pose(40000, 40000, 0.7), eye, RayModel::power_matrix,
                             foveal(0.4));  // pixels of 35 µrad
  const auto block = block_of(camera, 36000, 9000);
  const Eigen::Vector3d gaze = Eigen::Vector3d(16000.5 / 20000 * 0.7, 10999.5 / 20000 * 0.7, -1.0).normalized();
  const Eigen::Vector3d pupil = 13.5 * mm * (gaze + Eigen::Vector3d(0, 0, 1)), target = pupil + 0.4 * gaze;
  for (int i = 0; i < 16; ++i) {
    const LightRay ray = ray_of(block, i);
    EXPECT_NEAR((ray.origin - pupil).dot(gaze), 0.0, 1e-6);  // the pupil's disc stands across the line of sight
    EXPECT_LT((ray.origin - pupil).norm(), 3.001 * mm);
    const double t = (target - ray.origin).dot(gaze) / ray.direction.dot(gaze);
    EXPECT_LT((ray.origin + t * ray.direction - target).norm(), 0.02 * mm);  // half a pixel at 0.4 m
  }
}

TEST(GeneralCamera, BeyondItsAmplitudeAFovealEyeDoesWhatItCan) {
  // 1 D of 2.5: at 0.4 m the rays have 1.5 D · 3 mm · 0.4 m of blur left at most.
  const GeneralCamera camera(straight_pose(40000, 40000, 0.7), emmetrope(6.0, BestAccommodation{1.0}),
                             RayModel::power_matrix, foveal(0.4));
  const auto block = block_of(camera, 20000, 20000);
  for (int i = 0; i < 16; ++i) {
    const LightRay ray = ray_of(block, i);
    const Eigen::Vector3d at = ray.origin - 0.4 / ray.direction.z() * ray.direction;
    EXPECT_NEAR(at.head<2>().norm() / ray.origin.head<2>().norm(), 1.5 * 0.4, 0.03);
  }
}

TEST(GeneralCamera, AFovealEyeFocusesThroughItsLens) {
  // Behind a lens of about −5 D an emmetrope has to accommodate by some 5 D for what is far; then the rays that leave
  // the lens are parallel.
  Spectacles minus;
  minus.front = SphereSurface{0.0};
  minus.back = SphereSurface{1.0 / 0.1};
  minus.center_thickness_m = 2 * mm;
  ViewOptions options = foveal(std::numeric_limits<double>::infinity());
  options.spectacles = minus;
  const GeneralCamera camera(straight_pose(40000, 40000, 0.7), emmetrope(4.0, BestAccommodation{9.0}),
                             RayModel::power_matrix, options);
  const auto block = block_of(camera, 20000, 20000);
  for (int i = 0; i < 16; ++i) {
    const Eigen::Vector3d d = ray_of(block, i).direction;
    // A pixel is 35 µrad; spherical aberration of the lens at 2 mm: r³ n²/(2 (n−1)² …) below 0.02 mrad.
    EXPECT_LT(d.head<2>().norm(), 6e-5);
  }
}

TEST(GeneralCamera, ThePictureOfAPointIsThePointReflectionOfTheRays) {
  // Horizontal coma, examiner's +0.5 µm over 6 mm: its mean slope over the pupil is not zero. The mean of ∂Z(3,1)/∂x =
  // √8 (9x² + 3y² − 2) is √8 (9/4 + 3/4 − 2) = √8; so the examiner's −∇W has the mean −√8 c/a along his x, which is +√8
  // c/a along the wearer's.
  const double c = 0.5e-6, a = 3 * mm, expected = 2.8284271247461903 * c / a;
  std::vector<double> coefficients(9, 0.0);
  coefficients[8] = c;
  const Eye eye = Eye::with(ZernikeWave::from_examiner(coefficients, a), SecondOrder::LeastSquares, {}, 2 * a);
  SceneDescription description;
  description.materials = {testing::lambertian(Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones())};
  const float side = 0.2f;  // at 100 m: 2 mrad
  description.meshes = {testing::parallelogram({-0.5f * side, -0.5f * side, -100.0f}, {side, 0, 0}, {0, side, 0}, 0)};
  const Scene scene(description);
  const CameraPose pose = straight_pose(64, 64, 6e-3);  // the rim's rays are bent by up to 7√8 c/a = 3.3 mrad
  RenderSettings settings;
  settings.samples_per_pixel = 4096;
  settings.max_bounces = 0;
  const Image image = render(scene, EyeCamera(pose, EyeRays<float>(RayModel::zernike, eye, 0.0)), settings).radiance;
  double mass = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double value = static_cast<double>(image.at(x, y)[0]);
      mass += value;
      first += value * pixel_slope(pose) * Eigen::Vector2d(x + 0.5 - 32.0, 32.0 - y - 0.5);
    }
  // The pupil's own mean position adds nothing. 2 % are 9.4 µrad: 5σ of the 464 000 samples that hit, each off by 1.3
  // mrad.
  EXPECT_NEAR(first.x() / mass, -expected, 0.02 * expected);
  EXPECT_NEAR(first.y() / mass, 0.0, 0.02 * expected);
}

}  // namespace
}  // namespace sturm
