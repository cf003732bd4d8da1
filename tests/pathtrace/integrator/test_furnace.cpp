// Furnace: in a closed room whose walls all have radiance E and albedo ρ, every direction shows the same radiance. A
// path of at most `max_bounces` reflections collects E ρ^k at its k-th vertex, so the picture is the constant E Σ_{k ≤
// max_bounces} ρ^k.
#include <gtest/gtest.h>

#include <cmath>

#include "pathtrace/film/render.h"
#include "support/replicates.h"
#include "support/scenes.h"

namespace sturm {
namespace {

const Eigen::Vector3f emission(1.0f, 0.25f, 7.0f);
constexpr int seeds = 32;

CameraPose inside_the_room() {
  CameraPose pose;
  pose.position = {0.2, -0.1, 0.3};
  pose.look_at = {-0.5, 0.4, -1.0};
  pose.vertical_field = 1.0;
  pose.width = pose.height = 8;
  return pose;
}

RenderSettings settings(int samples, int bounces, std::uint64_t seed) {
  RenderSettings s;
  s.samples_per_pixel = samples;
  s.max_bounces = bounces;
  s.seed = seed;
  return s;
}

/// Mean of the picture in each channel over independent seeds, against `expected`.
void expect_constant(const Scene& scene, const EyeCamera& camera, int bounces, const Eigen::Vector3d& expected,
                     const std::string& what) {
  std::vector<double> means[3];
  for (int seed = 1; seed <= seeds; ++seed) {
    const RenderResult result = render(scene, camera, settings(16, bounces, static_cast<std::uint64_t>(seed)));
    for (int k = 0; k < 3; ++k) means[k].push_back(testing::image_mean(result.radiance, k));
  }
  for (int k = 0; k < 3; ++k) {
    const testing::Estimate e = testing::Estimate::of(means[k]);
    // 4 standard errors, and the rounding of 17 float additions and of the stored pixels where there is no noise.
    EXPECT_NEAR(e.mean, expected[k], 4.0 * e.standard_error + 2e-6 * expected[k]) << what << " channel " << k;
    // The test must be able to fail: 2 % is far less than one missing order of reflection.
    EXPECT_LT(e.standard_error, 5e-3 * expected[k]) << what << " channel " << k;
  }
}

Eigen::Vector3d closed_form(const Eigen::Vector3f& albedo, int bounces) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), power = Eigen::Vector3d::Ones();
  for (int k = 0; k <= bounces; ++k) {
    sum += power;
    power = power.cwiseProduct(albedo.cast<double>());
  }
  return sum.cwiseProduct(emission.cast<double>());
}

TEST(Furnace, EveryAlbedoAndPathLength) {
  const EyeCamera camera(inside_the_room(), testing::pinhole_rays());
  for (float rho : {0.0f, 0.3f, 0.6f, 0.9f}) {
    const Eigen::Vector3f albedo(rho, 0.5f * rho, 0.0f);
    SceneDescription description;
    description.materials = {testing::lambertian(albedo, emission)};
    description.meshes = testing::room(1.0f, 0);
    const Scene scene(description);
    for (int bounces : {0, 1, 4, 16})
      expect_constant(scene, camera, bounces, closed_form(albedo, bounces),
                      "albedo " + std::to_string(rho) + " bounces " + std::to_string(bounces));
  }
}

TEST(Furnace, EveryEyeSeesTheSame) {
  const Eigen::Vector3f albedo(0.6f, 0.3f, 0.1f);
  SceneDescription description;
  description.materials = {testing::lambertian(albedo, emission)};
  description.meshes = testing::room(1.0f, 0);
  const Scene scene(description);
  const Eye eye = Eye::with({-2.0, -1.5, 30.0, 0.0}, 0.04);
  for (RayModel model : {RayModel::thin_lens, RayModel::metalstigmatism, RayModel::sin2_radial, RayModel::power_matrix})
    expect_constant(scene, EyeCamera(inside_the_room(), {model, eye, 0.5, 2.0}), 4, closed_form(albedo, 4),
                    name_of(model));
}

// A grey sphere sees only the black room's radiance E and nothing of itself: ρE, unless its rays hit the sphere that
// they leave.
TEST(Furnace, ASphereDoesNotShadowItself) {
  struct {
    float room;
    Eigen::Vector3f center;
    float radius;
  } cases[] = {
      {2.0f, {0.3f, 0.2f, -0.4f}, 0.5f}, {100.0f, {50.0f, 40.0f, -60.0f}, 3.0f}, {2.0f, {0.01f, 0.0f, 0.02f}, 0.05f}};
  for (const auto& c : cases) {
    SceneDescription description;
    description.materials = {testing::lambertian(Eigen::Vector3f::Zero(), emission),
                             testing::lambertian({0.8f, 0.5f, 0.2f})};
    description.meshes = testing::room(c.room, 0);
    description.spheres = {{c.center, c.radius, 1}};
    CameraPose pose = inside_the_room();
    pose.look_at = c.center.cast<double>();
    pose.position = pose.look_at + 5.0 * static_cast<double>(c.radius) * Eigen::Vector3d(0.3, 0.1, 0.5).normalized();
    pose.vertical_field = 0.2;  // the sphere fills the picture
    expect_constant(Scene(description), EyeCamera(pose, testing::pinhole_rays()), 1,
                    emission.cwiseProduct(Eigen::Vector3f(0.8f, 0.5f, 0.2f)).cast<double>(),
                    "room " + std::to_string(c.room));
  }
}

}  // namespace
}  // namespace sturm
