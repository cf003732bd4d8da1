// Surfaces that rays pass: holes, veils, lamps with holes; and what vertices and textures bring to a point.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "pathtrace/plan/unseen_emitters.h"
#include "pathtrace/scene/embree_rays.h"
#include "pathtrace/scene/hit_packet.h"
#include "pathtrace/scene/scene.h"
#include "support/scenes.h"

namespace sturm {
namespace {

using Eigen::Vector3f;

/// A card of alpha `alpha` at z = −1 before a wall at z = −2, both facing +z.
SceneDescription card_before_wall(Opacity::Mode mode, float alpha) {
  SceneDescription scene;
  scene.materials = {testing::lambertian({1, 0, 0}), testing::lambertian({0, 1, 0})};
  scene.materials[0].opacity.mode = mode;
  scene.materials[0].opacity.factor = alpha;
  scene.meshes = {testing::parallelogram({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0),
                  testing::parallelogram({-5, -5, -2}, {10, 0, 0}, {0, 10, 0}, 1)};
  return scene;
}

std::optional<SurfacePoint> seen(const Scene& scene, const Vector3f& origin, const Vector3f& direction) {
  RTCRayHit ray = ray_from(origin, direction);
  if (!intersect(scene.embree(), ray)) return std::nullopt;
  return scene.surface_point(ray.hit, origin, direction, ray.ray.tfar);
}

/// Directions within the card, all different.
Vector3f direction(int i) {
  return {0.9f * std::sin(static_cast<float>(i)), 0.9f * std::cos(1.7f * static_cast<float>(i)), -1.0f};
}

TEST(CutOuts, AMaskStopsAllRaysOrNone) {
  for (const auto& [alpha, stops] : {std::pair{0.49f, false}, {0.5f, true}, {1.0f, true}, {0.0f, false}}) {
    const Scene scene(card_before_wall(Opacity::Mode::mask, alpha));
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(seen(scene, Vector3f::Zero(), direction(i))->albedo.x(), stops ? 1.0f : 0.0f) << alpha;
      // A shadow ray ends before the wall.
      EXPECT_EQ(occluded(scene.embree(), Vector3f::Zero(), 1.5f * direction(i)), stops) << alpha;
    }
  }
}

TEST(CutOuts, AVeilStopsItsShare) {
  const Scene scene(card_before_wall(Opacity::Mode::blend, 0.3f));
  constexpr int rays = 20000;
  int sight = 0, light = 0;
  for (int i = 0; i < rays; ++i) {
    sight += seen(scene, Vector3f::Zero(), direction(i))->albedo.x() > 0.0f;
    light += occluded(scene.embree(), Vector3f::Zero(), 1.5f * direction(i));
  }
  EXPECT_NEAR(sight / static_cast<double>(rays), 0.3, 0.013);  // 4σ = 4 √(0.3 · 0.7 / 20000)
  EXPECT_NEAR(light / static_cast<double>(rays), 0.3, 0.013);
}

TEST(CutOuts, TheSameRayMeetsTheSameSurfaceAloneAndInAPacket) {
  const Scene scene(card_before_wall(Opacity::Mode::blend, 0.5f));
  for (int first = 0; first < 400; first += HitPacket::size) {
    HitPacket packet;
    for (int lane = 0; lane < HitPacket::size; ++lane) packet.set(lane, Vector3f::Zero(), direction(first + lane));
    packet.first_hits(scene.embree());
    for (int lane = 0; lane < HitPacket::size; ++lane) {
      const auto alone = seen(scene, Vector3f::Zero(), direction(first + lane));
      ASSERT_TRUE(packet.hit(lane));
      const SurfacePoint together =
          scene.surface_point(packet.record(lane), Vector3f::Zero(), direction(first + lane), packet.distance(lane));
      EXPECT_EQ(alone->albedo, together.albedo);
    }
  }
}

TEST(CutOuts, TheAlphaOfVerticesIsInterpolated) {
  SceneDescription description = card_before_wall(Opacity::Mode::mask, 1.0f);
  description.meshes[0].vertex_colours = {
      {1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};  // from left to right
  const Scene scene(description);
  for (const float x : {-0.9f, -0.1f, 0.1f, 0.9f})
    EXPECT_EQ(seen(scene, Vector3f::Zero(), {x, 0.05f, -1.0f})->albedo.x(), x < 0.0f ? 0.0f : 1.0f) << x;
}

TEST(CutOuts, InstancesHaveHoles) {
  SceneDescription description = card_before_wall(Opacity::Mode::mask, 1.0f);
  description.meshes[0].vertex_colours = {{1, 0.5f, 1, 0}, {1, 0.5f, 1, 1}, {1, 0.5f, 1, 1}, {1, 0.5f, 1, 0}};
  description.materials[0].albedo = {1, 1, 0};
  description.prototypes = {description.meshes[0]};
  description.meshes.erase(description.meshes.begin());
  Instance moved{0, Eigen::Matrix<float, 3, 4>::Identity()};
  moved.world_from_prototype.col(3) = Vector3f(0.5f, 0.0f, 0.0f);
  description.instances = {moved};
  const Scene scene(description);
  EXPECT_EQ(seen(scene, Vector3f::Zero(), {0.4f, 0.05f, -1.0f})->albedo, Vector3f(0, 1, 0));  // its left half
  const Vector3f right = seen(scene, Vector3f::Zero(), {0.6f, 0.05f, -1.0f})->albedo;
  EXPECT_LT((right - Vector3f(1, 0.5f, 0)).norm(), 1e-6f);  // rounding of float
}

TEST(CutOuts, ASceneWithoutThemIsAsBefore) {
  const Scene with(card_before_wall(Opacity::Mode::opaque, 0.0f));
  EXPECT_EQ(seen(with, Vector3f::Zero(), {0, 0, -1})->albedo, Vector3f(1, 0, 0));
  EXPECT_EQ(with.kind(), Scene::Kind::plain);
}

TEST(Emitters, BothSidesAreLightsOfTheirOwn) {
  SceneDescription description = card_before_wall(Opacity::Mode::opaque, 1.0f);
  description.materials[0].emission = {3, 2, 1};
  const Scene one_sided(description);
  EXPECT_EQ(one_sided.lights().size(), 2);
  description.materials[0].emits_behind = true;
  const Scene scene(description);
  ASSERT_EQ(scene.lights().size(), 4);
  EXPECT_EQ(scene.lights().groups().size(), 2);  // one for each side, so that each is a panel
  for (const auto& [origin, towards] :
       {std::pair{Vector3f(0, 0.1f, 0), Vector3f(0, 0, -1)}, {Vector3f(0, 0.1f, -1.5f), Vector3f(0, 0, 1)}}) {
    const auto point = seen(scene, origin, towards);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->emission, Vector3f(3, 2, 1));
    EXPECT_LT(point->normal.dot(towards), -0.999f);
    const LightShape shape = scene.lights().shape(point->emitter);
    const Vector3f normal = (shape.corners[1] - shape.corners[0]).cross(shape.corners[2] - shape.corners[0]);
    EXPECT_LT(normal.dot(towards), 0.0f);  // the light that is met is the one of this side
  }
}

TEST(Emitters, UnseenOnesAreNumberedAsTheSceneNumbersThem) {
  // Lamps with holes are numbered last; the wall is behind both lamps, whose backs alone see it.
  SceneDescription description = card_before_wall(Opacity::Mode::mask, 1.0f);
  description.materials[0].emission = {1, 1, 1};
  description.materials.push_back(testing::lambertian({1, 1, 1}, {1, 1, 1}));
  description.materials[2].emits_behind = true;
  description.meshes.push_back(testing::parallelogram({-1, -1, -1.0f}, {2, 0, 0}, {0, 2, 0}, 2));
  const std::vector<int> unseen = unseen_emitters(description);
  // Plain lamp: fronts 0 and 2 see nothing, backs 1 and 3 see the wall. Lamp with holes: 4 and 5 see nothing.
  EXPECT_EQ(unseen, (std::vector<int>{0, 2, 4, 5}));
  const Scene scene(description);
  ASSERT_EQ(scene.lights().size(), 6);
  EXPECT_TRUE(scene.lights().shape(1).behind);
  EXPECT_TRUE(scene.lights().shape(4).varies);
}

TEST(Textures, AreMappedBeforeTheyAreWrapped) {
  SceneDescription description = card_before_wall(Opacity::Mode::opaque, 1.0f);
  auto picture = std::make_shared<Image>(2, 1, 3);
  picture->at(1, 0)[0] = 1.0f;  // black and red
  Material& material = description.materials[0];
  material.albedo_texture = picture;
  material.albedo_mapping.picture_from_mesh << 2, 0, 0.25f, 0, 1, 0;
  material.albedo_mapping.wrap_u = TextureWrap::Mirror;
  description.meshes[0].texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Scene scene(description);
  // u = 0, 1/4, 1/2, 3/4 → 2 u + 1/4 = 0.25, 0.75, 1.25 (0.75 mirrored), 1.75 (0.25)
  for (const auto& [u, red] : {std::pair{0.01f, 0.0f}, {0.25f, 1.0f}, {0.5f, 1.0f}, {0.75f, 0.0f}})
    EXPECT_EQ(seen(scene, Vector3f::Zero(), {2 * u - 1, 0.05f, -1.0f})->albedo.x(), red) << u;
}

}  // namespace
}  // namespace sturm
