// The part of the picture that a pinhole draws as well: every ray of a sharp cell stays within the bound.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>

#include "pathtrace/cameras/sharp_cells.h"
#include "pathtrace/film/render.h"
#include "pathtrace/scene/embree_rays.h"
#include "support/scenes.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Panels 1.5 m high at several distances side by side, a sphere, a floor that runs from below the eye to far away: the
/// eye is at the origin and looks along −z.
SceneDescription panels(const std::vector<float>& distances) {
  SceneDescription scene;
  scene.materials = {testing::lambertian({0.5f, 0.5f, 0.5f}, {1.0f, 1.0f, 1.0f})};
  const float step = 0.9f / static_cast<float>(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const float d = distances[i], left = d * (-0.45f + step * static_cast<float>(i));
    scene.meshes.push_back(
        testing::parallelogram({left, 0.0f, -d}, {0.8f * step * d, 0.0f, 0.0f}, {0.0f, 0.4f * d, 0.02f * d}, 0));
  }
  scene.meshes.push_back(testing::parallelogram({-40.0f, -1.6f, 3.0f}, {80.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -120.0f}, 0));
  scene.spheres.push_back({{0.0f, -0.3f, -2.0f}, 0.1f, 0});
  return scene;
}

CameraPose ahead(int width, int height) {
  CameraPose pose;
  pose.vertical_field = 0.9;
  pose.width = width;
  pose.height = height;
  return pose;
}

/// Where a ray's hit appears in the picture of the pupil's centre [px].
Eigen::Vector2d place_of_hit(const CameraPose& pose, const Vector3d& hit) {
  const Vector3d p = head_axes(pose).transpose() * (hit - pose.position);
  const Eigen::Vector2d slope(p.x() / -p.z(), p.y() / -p.z());
  return {0.5 * pose.width + slope.x() / pixel_slope(pose), 0.5 * pose.height - slope.y() / pixel_slope(pose)};
}

/// How far from its own place in the picture [px] the ray of a sample meets something; none where it meets nothing.
std::optional<double> wandering_px(const Scene& scene, const CameraPose& pose, const EyeCamera& camera, int x, int y,
                                   std::uint32_t sample, const PixelSequence& sequence) {
  const EyeCamera::Pixel pixel = camera.pixel(x, y);
  const EyeCamera::SamplePlace at = camera.place_of(pixel, sample, sequence);
  const CameraRay ray = camera.single(pixel, at);
  RTCRayHit hit = ray_from(ray.origin, ray.direction);
  if (!intersect(scene.embree(), hit)) return std::nullopt;
  const Eigen::Vector2d seen = place_of_hit(pose, (ray.origin + hit.ray.tfar * ray.direction).cast<double>());
  return (seen - at.film.cast<double>()).norm();
}

/// Every ray of a sharp cell meets what it meets within the bound of its own place in the picture; and cells are not
/// blurred for nothing.
void expect_bound(const SceneDescription& description, const Eye& eye, double accommodation_D, double bound_px,
                  double least_share) {
  const CameraPose pose = ahead(160, 120);
  const Scene scene(description);
  const auto cells = sharp_cells(description, pose, eye, accommodation_D, bound_px);
  ASSERT_TRUE(cells);
  EXPECT_GT(static_cast<double>(cells->pixels()), least_share * pose.width * pose.height);
  const EyeRays<float> rays(RayModel::power_matrix, eye, accommodation_D);
  const EyeCamera camera(pose, rays);  // with points over the pupil everywhere
  double worst = 0.0;
  for (int y = 0; y < pose.height; ++y)
    for (int x = 0; x < pose.width; ++x) {
      if (!cells->at(x, y)) continue;
      const PixelSequence sequence(Sequence::Sobol, 3, static_cast<std::uint32_t>(y * pose.width + x));
      for (std::uint32_t sample = 0; sample < 16; ++sample)
        worst = std::max(worst, wandering_px(scene, pose, camera, x, y, sample, sequence).value_or(0.0));
    }
  EXPECT_LE(worst, bound_px + 2e-4);  // single precision: 1e-7 of slopes of about 1, over pixels of 0.008
  EXPECT_GT(worst, 0.2 * bound_px);   // the bound is not an idle one
}

TEST(SharpCells, RaysStayWithinTheBound) {
  // Relaxed emmetrope: sharp from a distance on. In focus at 2 m: a range about it. A cylinder that leaves a little
  // blur everywhere.
  expect_bound(panels({2.0f, 8.0f, 20.0f, 60.0f}), Eye::with({}, 2e-3), 0.0, 0.02, 0.05);
  expect_bound(panels({2.0f, 2.05f, 1.9f, 60.0f}), Eye::with({}, 2e-3), 0.5, 0.01, 0.01);
  expect_bound(panels({2.0f, 8.0f, 20.0f, 60.0f}), Eye::with({0.0, -0.05, 30.0}, 3e-3), 0.0, 0.05, 0.05);
  // What is near reaches 15 px, two cells, over what is sharp.
  expect_bound(panels({0.4f, 60.0f, 60.0f, 60.0f}), Eye::with({}, 100e-3), 0.0, 0.15, 0.05);
}

TEST(SharpCells, PropertyRaysStayWithinTheBound) {
  rc::check([] {
    const auto scaled = [](int low, int high, double unit) { return unit * *rc::gen::inRange(low, high); };
    std::vector<float> distances;
    for (int i = 0; i < 4; ++i) distances.push_back(static_cast<float>(std::exp(scaled(-10, 40, 0.1))));
    const double focus_D = scaled(0, 20, 0.1), bound_px = scaled(1, 50, 0.01);
    const Eye eye = Eye::with({0.0, scaled(-4, 1, 0.02), scaled(0, 180, 1.0)}, scaled(2, 60, 1e-4));
    const SceneDescription description = panels(distances);
    const CameraPose pose = ahead(64, 48);
    const auto cells = sharp_cells(description, pose, eye, focus_D, bound_px);
    if (!cells) return;
    const Scene scene(description);
    const EyeCamera camera(pose, EyeRays<float>(RayModel::sin2_radial, eye, focus_D));
    for (int y = 0; y < pose.height; y += 3)
      for (int x = 0; x < pose.width; x += 3) {
        if (!cells->at(x, y)) continue;
        const PixelSequence sequence(Sequence::Sobol, 5, static_cast<std::uint32_t>(y * pose.width + x));
        for (std::uint32_t sample = 0; sample < 4; ++sample) {
          const std::optional<double> wandering = wandering_px(scene, pose, camera, x, y, sample, sequence);
          if (wandering) RC_ASSERT(*wandering <= bound_px + 1e-3);  // rounding: pixels of 0.02 rad, 54 m away
        }
      }
  });
}

TEST(SharpCells, AFaceOfOneDepthBlursTheCellsAroundIt) {
  // In focus at 1 m; a lamp at 0.5 m, half a pixel wide, parallel to the picture. Its blur has the radius
  // 2 mm · (2 − 1) D = 2 mrad.
  CameraPose pose = ahead(64, 48);
  pose.vertical_field = 0.02;
  SceneDescription scene;
  scene.materials = {testing::lambertian({0.5f, 0.5f, 0.5f}, {1.0f, 1.0f, 1.0f})};
  scene.meshes.push_back(testing::parallelogram({0.0f, 0.0f, -0.5f}, {1e-4f, 0.0f, 0.0f}, {0.0f, 1e-4f, 0.0f}, 0));
  const auto cells = sharp_cells(scene, pose, Eye::with({}, 2e-3), 1.0, 0.02);
  ASSERT_TRUE(cells);
  const int reach_px = static_cast<int>(2e-3 / pixel_slope(pose));
  ASSERT_GE(reach_px, 4);
  for (const int aside : {-reach_px + 1, 0, reach_px - 1}) {
    EXPECT_FALSE(cells->at(32 + aside, 24)) << aside;
    EXPECT_FALSE(cells->at(32, 24 + aside)) << aside;
  }
  EXPECT_TRUE(cells->at(0, 0));
}

TEST(SharpCells, NoneWhereNothingCanBeSharp) {
  const CameraPose pose = ahead(64, 48);
  const SceneDescription scene = panels({2.0f, 8.0f});
  EXPECT_FALSE(
      sharp_cells(scene, pose, Eye::with({-2.0, -1.5, 30.0}, 4e-3), 0.0, 0.02));  // a cylinder blurs every distance
  EXPECT_FALSE(sharp_cells(scene, pose, Eye::with({3.0}, 4e-3), 0.0, 0.02));      // a hyperope's focus lies behind him
  SceneDescription around = panels({2.0f});
  auto sky = std::make_shared<Image>(2, 1, 3);
  sky->pixels = {1, 1, 1, 2, 2, 2};
  around.environment = Environment{{1.0f, 1.0f, 1.0f}, sky, 0.0f};
  EXPECT_FALSE(
      sharp_cells(around, pose, Eye::with({-0.5}, 2e-3), 0.0, 0.02));  // the sky is at infinity, the focus at 2 m
  around.environment->map = nullptr;
  EXPECT_TRUE(sharp_cells(around, pose, Eye::with({-0.5}, 2e-3), 0.0, 0.02));
}

TEST(SharpCells, SlowThePicturesEdgesMoveByLessThanTheBound) {
  // One bright panel before black, an emitter seen directly: every pixel is the share of its box that the panel covers.
  SceneDescription description;
  description.materials = {testing::lambertian(Vector3f::Zero(), {1.0f, 1.0f, 1.0f})};
  description.meshes = {testing::parallelogram({-3.0f, -3.3f, -20.0f}, {6.0f, 1.1f, 0.0f}, {-1.1f, 6.0f, 0.0f}, 0)};
  const Scene scene(description);
  const CameraPose pose = ahead(64, 48);
  const double bound_px = 0.1;
  const Eye eye = Eye::with({}, 2.0 * 0.99 * bound_px * pixel_slope(pose) * 20.0);
  const auto cells = sharp_cells(description, pose, eye, 0.0, bound_px);
  ASSERT_TRUE(cells);
  EXPECT_EQ(cells->pixels(), 64u * 48u);
  const EyeRays<float> rays(RayModel::thin_lens, eye, 0.0);
  RenderSettings settings;
  settings.samples_per_pixel = 4096;
  const RenderResult with = render(scene, EyeCamera(pose, rays), settings);
  const RenderResult without = render(scene, EyeCamera(pose, rays, {true, cells}), settings);
  float worst = 0.0f;
  for (std::size_t i = 0; i < with.radiance.pixels.size(); ++i)
    worst = std::max(worst, std::abs(with.radiance.pixels[i] - without.radiance.pixels[i]));
  // √2 · contrast · bound, and scrambled Sobol' points on an edge: N^-3/4 = 0.002 each.
  EXPECT_LE(worst, std::sqrt(2.0f) * 0.1f + 0.01f);
  EXPECT_GT(worst, 0.001f);
}

TEST(SharpCells, SharpPixelsAreThePinholesBits) {
  const SceneDescription description = panels({2.0f, 8.0f, 20.0f, 60.0f});
  const CameraPose pose = ahead(64, 48);
  const Eye eye = Eye::with({}, 2e-3);
  const auto cells = sharp_cells(description, pose, eye, 0.0, 0.02);
  ASSERT_TRUE(cells);
  const Scene scene(description);
  RenderSettings settings;
  settings.samples_per_pixel = 20;  // not a multiple of the block
  settings.max_bounces = 3;
  settings.guide_emitters = true;  // where all rays go through one point there is nothing to guide
  const EyeRays<float> rays(RayModel::thin_lens, eye, 0.0);
  const RenderResult lens = render(scene, EyeCamera(pose, rays), settings);
  const RenderResult mixed = render(scene, EyeCamera(pose, rays, {true, cells}), settings);
  const RenderResult pinhole = render(scene, EyeCamera(pose, EyeRays<float>(RayModel::pinhole, eye, 0.0)), settings);
  for (int y = 0; y < pose.height; ++y)
    for (int x = 0; x < pose.width; ++x)
      for (int k = 0; k < 3; ++k)
        ASSERT_EQ(mixed.radiance.at(x, y)[k], (cells->at(x, y) ? pinhole : lens).radiance.at(x, y)[k]) << x << " " << y;
}

}  // namespace
}  // namespace sturm
