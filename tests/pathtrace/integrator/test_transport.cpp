// Paths over every surface model against closed forms: furnaces, slabs and mirrors, and the loop without materials
// against the one with.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "pathtrace/film/render.h"
#include "support/replicates.h"
#include "support/scenes.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::pi;
const Vector3f white(1.0f, 1.0f, 1.0f), black(0.0f, 0.0f, 0.0f);

Material surface(const SurfaceModel& model, const Vector3f& albedo = white) {
  Material material = testing::lambertian(albedo);
  material.surface = model;
  return material;
}

std::shared_ptr<const Image> constant_picture(float value) {
  auto image = std::make_shared<Image>(8, 4, 3);
  image->pixels.assign(image->pixels.size(), value);
  return image;
}

testing::Estimate measured(const Scene& scene, const EyeCamera& camera, int samples, int bounces, int seeds = 16) {
  std::vector<double> values;
  for (int seed = 1; seed <= seeds; ++seed) {
    RenderSettings settings;
    settings.samples_per_pixel = samples;
    settings.max_bounces = bounces;
    settings.seed = static_cast<std::uint64_t>(seed);
    values.push_back(testing::image_mean(render(scene, camera, settings).radiance, 0));
  }
  return testing::Estimate::of(values);
}

void expect_near(const testing::Estimate& e, double expected, const std::string& what) {
  EXPECT_NEAR(e.mean, expected, 4.0 * e.standard_error + 1e-5 * expected) << what;  // rounding of float sums
  EXPECT_LE(e.standard_error, 0.01 * std::max(expected, 0.1)) << what;
}

/// Mean weight of single scattering of a model for one direction of view.
double albedo_of(const SurfaceModel& model, const Vector3f& out, const Vector3f& albedo) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<float> uniform(0.0f, 0.9999999f);
  double sum = 0.0;
  constexpr int n = 1 << 20;
  for (int i = 0; i < n; ++i) {
    const float u = uniform(random), v = uniform(random), lobe = uniform(random);
    const BsdfSample s = sample(model, out, {u, v, lobe}, albedo);
    if (s.pdf > 0.0f) sum += static_cast<double>(s.weight[0]);
  }
  return sum / n;
}

// One bounce on a plane under a sky of radiance 2: twice the model's albedo, whether the sky is a colour (no sampling
// of lights at all) or a picture (lights and surface sampled and weighted). A wrong weight or density shows in the
// second and not in the first.
TEST(Transport, SlowEveryOpaqueModelUnderAConstantSky) {
  const Vector3f albedo(0.8f, 0.8f, 0.8f);
  for (const SurfaceModel& model : std::vector<SurfaceModel>{
           Diffuse{}, Conductor{black, white, 0.0f}, Conductor{black, white, 0.3f}, Conductor{black, white, 0.8f},
           Plastic(1.5f, 0.0f), Plastic(1.5f, 0.4f), SeedDiffuse{}, SeedMetal{0.0f}, SeedMetal{0.5f}, SeedMetal{1.0f}})
    for (bool sampled : {false, true})
      for (bool from_behind : {false, true}) {
        SceneDescription description;
        description.materials = {surface(model, albedo)};
        description.meshes = {testing::parallelogram({-5, 0, -5}, {0, 0, 10}, {10, 0, 0}, 0)};
        description.environment = Environment{2.0f * white, sampled ? constant_picture(1.0f) : nullptr, 0.0f};
        const double up = from_behind ? -0.6 : 0.6;
        const testing::Estimate e =
            measured(Scene(description), testing::spot_meter({0.8, up, 0.0}, {0, 0, 0}), 4096, 1);
        const double expected = 2.0 * albedo_of(model, {0.8f, 0.0f, 0.6f}, albedo);
        // … and the reference's own error, 4 · 0.5/√2^20.
        EXPECT_NEAR(e.mean, expected, 4.0 * e.standard_error + 2.0 * 2e-3)
            << "model " << model.index() << " sampled " << sampled;
        EXPECT_LE(e.standard_error, 0.02);
      }
}

// Whoever looks at clear glass in a furnace sees the furnace: all that is not reflected is refracted, and comes from
// everywhere too.
TEST(Transport, AGlassBallIsInvisibleInAFurnace) {
  for (bool sampled : {false, true}) {
    SceneDescription description;
    description.materials = {surface(Dielectric{1.5f, 0.0f})};
    description.spheres = {{{0, 0, -3}, 1.0f, 0}};
    description.environment = Environment{white, sampled ? constant_picture(1.0f) : nullptr, 0.0f};
    CameraPose pose;
    pose.look_at = {0, 0, -3};
    pose.vertical_field = 0.5;
    pose.width = pose.height = 8;
    expect_near(measured(Scene(description), EyeCamera(pose, testing::pinhole_rays()), 256, 64), 1.0, "glass ball");
  }
}

// A rough ball loses what its two surfaces lose, and no more: between the loss of one and of many encounters.
TEST(Transport, ARoughGlassBallLosesALittle) {
  SceneDescription description;
  description.materials = {surface(Dielectric{1.5f, 0.5f})};
  description.spheres = {{{0, 0, -3}, 1.0f, 0}};
  description.environment = Environment{white, constant_picture(1.0f), 0.0f};
  const testing::Estimate e = measured(Scene(description), testing::spot_meter({0, 0, 0}, {0, 0, -3}), 4096, 64);
  EXPECT_LT(e.mean, 1.0);
  EXPECT_GT(e.mean, 0.9);
  EXPECT_LT(e.standard_error, 0.01);
}

// A slab of index 1.5 seen straight on, light only behind it: all orders together transmit (1 − R)/(1 + R) = 0.96/1.04,
// R = 0.04.
TEST(Transport, ASlabTransmitsAllOrders) {
  auto picture = std::make_shared<Image>(4, 2, 3);
  for (int y = 0; y < 2; ++y)
    for (int x = 1; x < 3; ++x)
      for (int k = 0; k < 3; ++k) picture->at(x, y)[k] = 1.0f;  // the half around −z
  SceneDescription description;
  description.materials = {surface(Dielectric{1.5f, 0.0f})};
  description.meshes = {testing::parallelogram({-5, -5, -2}, {10, 0, 0}, {0, 10, 0}, 0),   // faces +z
                        testing::parallelogram({-5, -5, -3}, {0, 10, 0}, {10, 0, 0}, 0)};  // faces −z
  description.environment = Environment{white, picture, 0.0f};
  const Scene scene(description);
  expect_near(measured(scene, testing::spot_meter({0, 0, 0}, {0, 0, -2}), 4096, 32), 0.96 / 1.04, "ahead");
  expect_near(measured(scene, testing::spot_meter({0, 0, -9}, {0, 0, -3}), 4096, 32), 0.08 / 1.04,
              "mirrored");  // 2R/(1 + R)
}

// A smooth metal shows an emitter as F times its radiance, without noise; a point light never.
TEST(Transport, AMirrorShowsTheLamp) {
  SceneDescription description;
  description.materials = {surface(Conductor{{0.2f, 0.2f, 0.2f}, {3.9f, 3.9f, 3.9f}, 0.0f}),
                           testing::lambertian(black, 5.0f * white)};
  description.meshes = {testing::parallelogram({-5, 0, -5}, {0, 0, 10}, {10, 0, 0}, 0),
                        testing::parallelogram({-2, 2, -2}, {4, 0, 0}, {0, 0, 4}, 1)};  // x × z = −y: shines down
  description.lights = {{{0.0f, 1.0f, 0.0f}, white}};
  const testing::Estimate e = measured(Scene(description), testing::spot_meter({0.001, 1.0, 0.0}, {0, 0, 0}), 16, 4);
  EXPECT_NEAR(e.mean, 5.0 * (0.64 + 15.21) / (1.44 + 15.21), 1e-4);  // ((η − 1)² + κ²)/((η + 1)² + κ²)
  EXPECT_LT(e.standard_error, 1e-6);
}

/// The room of the furnace with a lamp in it and a ball.
SceneDescription lamp_room() {
  SceneDescription description;
  description.materials = {testing::lambertian({0.6f, 0.5f, 0.3f}), testing::lambertian(black, {8.0f, 6.0f, 4.0f})};
  description.meshes = testing::room(1.0f, 0);
  description.meshes.push_back(testing::parallelogram({-0.3f, 0.9f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}, 1));
  description.spheres = {{{0.1f, -0.6f, -0.3f}, 0.3f, 0}, {{-0.6f, 0.4f, -0.5f}, 0.1f, 1}};
  description.lights = {{{0.5f, 0.2f, 0.3f}, {0.2f, 0.2f, 0.2f}}};
  return description;
}

CameraPose in_the_room() {
  CameraPose pose;
  pose.position = {0.2, -0.1, 0.9};
  pose.look_at = {0.0, 0.0, -1.0};
  pose.vertical_field = 1.2;
  pose.width = pose.height = 16;
  return pose;
}

TEST(Transport, TheThreeLoopsAgreeOnDiffuseScenes) {
  const EyeCamera camera(in_the_room(), testing::pinhole_rays());
  SceneDescription description = lamp_room();
  const Scene plain(description);
  ASSERT_EQ(plain.kind(), Scene::Kind::plain);
  const testing::Estimate expected = measured(plain, camera, 128, 8);
  SceneDescription smooth = description;  // flat normals, spelt out
  for (Mesh& mesh : smooth.meshes) {
    const Vector3f n =
        (mesh.positions[1] - mesh.positions[0]).cross(mesh.positions[2] - mesh.positions[0]).normalized();
    mesh.normals.assign(mesh.positions.size(), n);
  }
  const Scene diffuse(smooth);
  ASSERT_EQ(diffuse.kind(), Scene::Kind::diffuse);
  description.materials.push_back(surface(Conductor{}));  // nothing uses it
  const Scene mixed(description);
  ASSERT_EQ(mixed.kind(), Scene::Kind::mixed);
  for (const Scene* scene : {&diffuse, &mixed}) {
    const testing::Estimate e = measured(*scene, camera, 128, 8);
    EXPECT_NEAR(e.mean, expected.mean, 4.0 * std::hypot(e.standard_error, expected.standard_error));
    EXPECT_LT(e.standard_error, 5e-3 * expected.mean);
  }
}

// A smooth coat over white under a sky reflects everything at every bounce; a room of it shows E Σ 1 = E (bounces + 1).
TEST(Transport, AWhitePlasticRoomIsAFurnace) {
  SceneDescription description;
  Material wall = surface(Plastic(1.5f, 0.0f));
  wall.emission = white;
  description.materials = {wall};
  description.meshes = testing::room(1.0f, 0);
  expect_near(measured(Scene(description), EyeCamera(in_the_room(), testing::pinhole_rays()), 64, 3), 4.0,
              "plastic room");
}

// A sphere of triangles with smooth normals, 24 × 12: in a furnace it stays as bright as its albedo but for what bends
// below the facets.
TEST(SmoothNormals, NoLightLeaksAndLittleIsLost) {
  SceneDescription description;
  description.materials = {testing::lambertian({0.8f, 0.8f, 0.8f})};
  Mesh ball;
  ball.name = "ball";
  constexpr int around = 24, rows = 12;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= around; ++i) {
      const double theta = pi * j / rows, phi = 2.0 * pi * i / around;
      const Vector3f n =
          Vector3d(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)).cast<float>();
      ball.normals.push_back(n);
      ball.positions.push_back(n + Vector3f(0, 0, -3));
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = j * (around + 1) + i, b = a + around + 1;
      if (j > 0) ball.triangles.push_back({a, b, a + 1});
      if (j + 1 < rows) ball.triangles.push_back({a + 1, b, b + 1});
    }
  description.meshes = {ball};
  description.environment = Environment{white, constant_picture(1.0f), 0.0f};
  const Scene scene(description);
  const testing::Estimate e = measured(scene, testing::spot_meter({0, 0, 0}, {0.31, 0.27, -3}), 4096, 8);
  EXPECT_LE(e.mean, 0.8 + 4.0 * e.standard_error);
  EXPECT_GT(e.mean, 0.8 * 0.98);  // facets of 15°: directions up to 7.5° below them are lost, sin² 7.5° = 1.7 %
  // Inside of a closed ball it is dark, whatever the shading normals say.
  EXPECT_EQ(measured(scene, testing::spot_meter({0, 0, -3}, {0.31, 0.27, -2.1}), 4096, 8).mean, 0.0);
}

}  // namespace
}  // namespace sturm
