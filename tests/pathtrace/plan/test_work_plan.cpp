// What the plan of work leaves out: each item's promise about the picture, on a scene that profits.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "pathtrace/film/render.h"
#include "pathtrace/plan/simplest_environment.h"
#include "pathtrace/plan/simplest_model.h"
#include "pathtrace/plan/unseen_emitters.h"
#include "support/replicates.h"
#include "support/same_bytes.h"
#include "support/scene_plain.h"
#include "support/scenes.h"

namespace sturm {
namespace {

using testing::same_bytes;

using Eigen::Vector3f;

CameraPose small_room_pose() {
  CameraPose pose = testing::scene_plain_pose();
  pose.width = pose.height = 24;
  return pose;
}

CameraPose few_pixels() {
  CameraPose pose;
  pose.vertical_field = 0.9;
  pose.width = pose.height = 16;
  return pose;
}

RenderSettings few_samples(Sequence sequence = Sequence::Sobol) {
  RenderSettings settings;
  settings.samples_per_pixel = 20;  // not a multiple of the block
  settings.sequence = sequence;
  settings.max_bounces = 3;
  return settings;
}

// ---- Ray models

TEST(SimplestModel, WithoutACylinderThePowerMatrixIsTheScalarModelBitByBit) {
  rc::check([] {
    const auto tenths = [](int low, int high) { return 0.1 * *rc::gen::inRange(low, high); };
    const Eye eye = Eye::with({tenths(-80, 80), 0.0, 180.0, 1e-3 * tenths(0, 150)}, 1e-3 * tenths(1, 80));
    const double accommodation = tenths(0, 40);
    RC_ASSERT(simplest_model(RayModel::power_matrix, eye).model == RayModel::thin_lens);
    RC_ASSERT(simplest_model(RayModel::power_matrix, eye).claim == PlanClaim::same_bits);
    const EyeRays<float> matrix(RayModel::power_matrix, eye, accommodation),
        scalar(RayModel::thin_lens, eye, accommodation);
    const float x = 1e-3f * static_cast<float>(tenths(-40, 40)), y = 1e-3f * static_cast<float>(tenths(-40, 40));
    const auto a = matrix.through(x, y), b = scalar.through(x, y);
    RC_ASSERT(a.sx == b.sx && a.sy == b.sy && a.px == b.px && a.py == b.py);
  });
}

TEST(SimplestModel, OtherModelsAgreeToRounding) {
  for (const double sphere : {-6.0, -0.25, 0.0, 3.5}) {
    const Eye spherical = Eye::with({sphere, 0.0, 180.0, 12e-3}, 6e-3),
              toric = Eye::with({sphere, -1.5, 30.0, 12e-3}, 6e-3);
    const auto compare = [](RayModel model, RayModel expected, const Eye& eye) {
      const SimplestModel simplest = simplest_model(model, eye);
      EXPECT_EQ(name_of(simplest.model), name_of(expected));
      const EyeRays<float> before(model, eye, 0.5), after(simplest.model, eye, 0.5);
      for (const auto& [x, y] : {std::pair{1e-3f, 0.4e-3f}, {-2.9e-3f, 0.1e-3f}, {0.7e-3f, -1.9e-3f}, {0.0f, 0.0f}}) {
        const auto a = before.through(x, y), b = after.through(x, y);
        // Four roundings of powers up to |P| + |A|, each half a unit of 2^-23, times the offset.
        const float bound =
            4.0f * 0x1p-23f * static_cast<float>(eye.correction.matrix().norm() + 0.5) * std::hypot(x, y);
        EXPECT_NEAR(a.sx, b.sx, bound);
        EXPECT_NEAR(a.sy, b.sy, bound);
      }
    };
    compare(RayModel::sin2_radial, RayModel::thin_lens, spherical);
    compare(RayModel::zernike, RayModel::thin_lens, spherical);
    compare(RayModel::zernike, RayModel::power_matrix, toric);
  }
}

TEST(SimplestModel, WhatIsNeededStays) {
  const Eye toric = Eye::with({-2.0, -0.25, 45.0}, 4e-3), spherical = Eye::with({-2.0}, 4e-3);
  for (const RayModel model : {RayModel::pinhole, RayModel::thin_lens, RayModel::metalstigmatism, RayModel::sin2_radial,
                               RayModel::power_matrix})
    EXPECT_EQ(simplest_model(model, toric).model, model) << name_of(model);
  EXPECT_EQ(simplest_model(RayModel::metalstigmatism, spherical).model, RayModel::metalstigmatism);
  const Eye measured =
      Eye::with(ZernikeWave::of_power(spherical.correction, 3e-3), SecondOrder::Paraxial, std::nullopt, 4e-3);
  EXPECT_EQ(simplest_model(RayModel::zernike, measured).model, RayModel::zernike);
}

// ---- Points over the pupil

TEST(ZeroPupil, TheSameBitsWithAndWithoutPointsOverIt) {
  const Scene scene(testing::scene_plain());
  const EyeRays<float> rays(RayModel::power_matrix, Eye::with({-3.0, -1.0, 20.0}, 0.0), 0.0);
  for (const Sequence sequence : {Sequence::Sobol, Sequence::Halton, Sequence::Independent}) {
    const RenderResult without = render(scene, EyeCamera(small_room_pose(), rays), few_samples(sequence));
    const RenderResult with =
        render(scene, EyeCamera(small_room_pose(), rays, {false, nullptr}), few_samples(sequence));
    EXPECT_TRUE(same_bytes(without.radiance, with.radiance));
    EXPECT_TRUE(same_bytes(without.variance, with.variance));
    EXPECT_TRUE(same_bytes(without.depth, with.depth));
  }
}

// ---- Lights

TEST(SimplestEnvironment, OneColourInPlaceOfAPictureOfIt) {
  auto picture = std::make_shared<Image>(3, 2, 3);
  for (std::size_t i = 0; i < picture->pixels.size(); ++i) picture->pixels[i] = 0.25f * static_cast<float>(1 + i % 3);
  const Environment flat{{2.0f, 1.0f, 0.1f}, picture, 0.7f};
  const auto simplest = simplest_environment(flat);
  ASSERT_TRUE(simplest);
  EXPECT_FALSE(simplest->map);
  const EnvironmentMap map(flat.map, flat.radiance, flat.rotation);
  EXPECT_EQ(simplest->radiance, map.radiance({0.3f, -0.2f, 0.9f}));
  for (std::size_t i = 0; i < picture->pixels.size(); ++i) {  // wherever the other colour is
    auto two = std::make_shared<Image>(*picture);
    two->pixels[i] += 0.25f;
    EXPECT_EQ(simplest_environment(Environment{{1.0f, 1.0f, 1.0f}, two, 0.0f})->map, two) << i;
  }
  auto black = std::make_shared<Image>(2, 2, 3);
  EXPECT_FALSE(simplest_environment(Environment{{1.0f, 1.0f, 1.0f}, black, 0.0f}));
  EXPECT_FALSE(simplest_environment(Environment{{0.0f, 0.0f, 0.0f}, nullptr, 0.0f}));
  EXPECT_FALSE(simplest_environment(std::nullopt));
}

/// Mean of a picture's green over replicates with different seeds.
testing::Estimate mean_of_picture(const Scene& scene, const EyeCamera& camera, RenderSettings settings,
                                  int replicates = 16) {
  std::vector<double> means;
  for (int r = 0; r < replicates; ++r) {
    settings.seed = static_cast<std::uint64_t>(100 + r);
    means.push_back(testing::image_mean(render(scene, camera, settings).radiance, 1));
  }
  return testing::Estimate::of(means);
}

TEST(SimplestEnvironment, TheSampledColourLightsAlike) {
  SceneDescription description;
  description.materials = {testing::lambertian({0.6f, 0.6f, 0.6f})};
  description.meshes = {testing::parallelogram({-2.0f, -1.0f, -6.0f}, {0.0f, 0.0f, 6.0f}, {4.0f, 0.0f, 0.0f}, 0)};
  description.spheres = {{{0.0f, -0.5f, -3.0f}, 0.5f, 0}};
  description.environment = Environment{{0.5f, 0.8f, 1.0f}, nullptr, 0.0f};
  const Scene colour(description);
  description.environment = sampled_environment(description.environment);
  ASSERT_TRUE(description.environment->map);
  const Scene sampled(description);
  const EyeCamera camera(few_pixels(), testing::pinhole_rays());
  const auto a = mean_of_picture(colour, camera, few_samples()), b = mean_of_picture(sampled, camera, few_samples());
  EXPECT_NEAR(a.mean, b.mean, 4.0 * std::hypot(a.standard_error, b.standard_error));  // 4σ
  EXPECT_LT(a.standard_error + b.standard_error, 0.01 * a.mean);
  EXPECT_EQ(render(colour, camera, few_samples()).counters.shadow_rays, 0u);
  EXPECT_GT(render(sampled, camera, few_samples()).counters.shadow_rays, 0u);
}

constexpr int hidden_panels = 40;  // more groups than the choice of a light weighs at each point

/// The room of scene_plain with bright panels above its ceiling that face upwards, away from everything.
SceneDescription room_with_hidden_panels() {
  SceneDescription description = testing::scene_plain();
  const int lamp = static_cast<int>(description.materials.size());
  description.materials.push_back(testing::lambertian({0.5f, 0.5f, 0.5f}, {50.0f, 50.0f, 50.0f}));
  for (int i = 0; i < hidden_panels; ++i) {
    const Vector3f corner(0.06f * static_cast<float>(i % 8), 1.0f, 0.06f * static_cast<float>(i / 8));
    description.meshes.push_back(testing::parallelogram(corner, {0.0f, 0.0f, 0.05f}, {0.05f, 0.0f, 0.0f}, lamp));
  }
  return description;
}

TEST(UnseenEmitters, ThoseThatFaceAwayAreFound) {
  EXPECT_TRUE(unseen_emitters(testing::scene_plain()).empty());
  std::vector<int> hidden;
  for (int i = 0; i < 2 * hidden_panels; ++i) hidden.push_back(2 + i);  // after the ceiling's two triangles
  EXPECT_EQ(unseen_emitters(room_with_hidden_panels()), hidden);
  SceneDescription seen = room_with_hidden_panels();
  seen.spheres.push_back({{0.2f, 2.0f, 0.2f}, 0.1f, 0});  // above the panels
  EXPECT_TRUE(unseen_emitters(seen).empty());
  seen.spheres.back().center.y() = 0.95f;  // its top comes through their plane
  EXPECT_TRUE(unseen_emitters(seen).empty());
  seen.spheres.back().center.y() = 0.85f;  // below their plane
  EXPECT_EQ(unseen_emitters(seen), hidden);
}

TEST(UnseenEmitters, TheMeanStaysAndNoiseFalls) {
  SceneDescription description = room_with_hidden_panels();
  const Scene all(description);
  description.unseen_emitters = unseen_emitters(description);
  const Scene fewer(description);
  const EyeCamera camera(small_room_pose(), testing::pinhole_rays());
  const auto a = mean_of_picture(all, camera, few_samples()), b = mean_of_picture(fewer, camera, few_samples());
  EXPECT_NEAR(a.mean, b.mean, 4.0 * std::hypot(a.standard_error, b.standard_error));  // 4σ
  // Nearly every choice was a hidden panel; the weights then rely on light that is met by chance. Measured: 0.71, of
  // 11520 paths each.
  const auto variance = [&](const Scene& scene) {
    return testing::image_mean(render(scene, camera, few_samples()).variance, 1);
  };
  EXPECT_LT(variance(fewer), 0.85 * variance(all));
}

TEST(UnseenEmitters, SlowWhatAPathMeetsOfThemCountsInFull) {
  // A lamp that is left out although it is seen: wrong for the noise only.
  SceneDescription description = testing::scene_plain();
  const Scene chosen(description);
  description.unseen_emitters = {0, 1};
  const Scene left_out(description);
  EXPECT_TRUE(left_out.lights().empty());
  const EyeCamera camera(small_room_pose(), testing::pinhole_rays());
  RenderSettings settings = few_samples();
  const auto a = mean_of_picture(chosen, camera, settings);
  settings.samples_per_pixel = 200;  // met by chance only
  const auto b = mean_of_picture(left_out, camera, settings);
  EXPECT_NEAR(a.mean, b.mean, 4.0 * std::hypot(a.standard_error, b.standard_error));  // 4σ
  EXPECT_LT(b.standard_error, 0.02 * b.mean);
  EXPECT_EQ(render(left_out, camera, few_samples()).counters.shadow_rays, 0u);
}

// ---- The path tracer's loops

TEST(LeastKind, ScenesSeenFromTheFrontHaveTheSameBitsWithAllMaterialModels) {
  SceneDescription description;
  description.materials = {testing::lambertian({0.7f, 0.6f, 0.5f}),
                           testing::lambertian({0.5f, 0.5f, 0.5f}, {4.0f, 4.0f, 4.0f})};
  description.meshes = testing::room(1.0f, 0);
  description.meshes.push_back(
      testing::parallelogram({-0.3f, 0.99f, -0.3f}, {0.6f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.6f}, 1));
  const Scene scene(description);
  ASSERT_EQ(scene.kind(), Scene::Kind::plain);
  const EyeCamera camera(few_pixels(), testing::pinhole_rays());
  RenderSettings settings = few_samples();
  settings.least_kind = Scene::Kind::diffuse;
  const RenderResult diffuse = render(scene, camera, settings);
  settings.least_kind = Scene::Kind::mixed;
  const RenderResult mixed = render(scene, camera, settings);
  EXPECT_TRUE(same_bytes(diffuse.radiance, mixed.radiance));
  settings.least_kind = Scene::Kind::plain;
  EXPECT_FALSE(same_bytes(diffuse.radiance, render(scene, camera, settings).radiance));  // other random numbers
}

TEST(LeastKind, SlowTheLoopsHaveTheSameMean) {
  const Scene scene(testing::scene_plain());
  const EyeCamera camera(small_room_pose(), testing::focused_lens(0.02, 1.05));
  RenderSettings settings = few_samples();
  const auto plain = mean_of_picture(scene, camera, settings);
  for (const Scene::Kind kind : {Scene::Kind::diffuse, Scene::Kind::mixed}) {
    settings.least_kind = kind;
    const auto other = mean_of_picture(scene, camera, settings);
    EXPECT_NEAR(plain.mean, other.mean, 4.0 * std::hypot(plain.standard_error, other.standard_error));  // 4σ
  }
}

}  // namespace
}  // namespace sturm
