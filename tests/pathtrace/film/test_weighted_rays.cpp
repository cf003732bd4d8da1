// Weights of pupil points apply to all that a ray sees. They once left out rays that meet nothing and see the
// environment: a study of pupil samplings (docs/scenes.md) showed uniform_polar_weighted to be biased by 3 to 6 %
// before a sky, nearly as much as without weights.
#include <gtest/gtest.h>

#include "lensmodel/eye.h"
#include "pathtrace/cameras/general_camera.h"
#include "pathtrace/film/render.h"

namespace sturm {
namespace {

TEST(WeightedRays, AWorldOfRadianceOneIsSeenAsOne) {
  // Parallel rays from a pupil of radius 10 mm: a glowing sphere of 5 mm fills its inner half (in radius), a sky of the
  // same radiance the rest. Weighted by 2r/a the inner points count 1/4 and the outer 3/4; with the sky unweighted the
  // sum would be 1/4 + 1/2.
  SceneDescription scene;
  Material glow;
  glow.emission = {1.0f, 1.0f, 1.0f};
  scene.materials.push_back(glow);
  scene.spheres.push_back({{0.0f, 0.0f, -1.0f}, 5e-3f, 0});
  scene.environment = Environment{};
  CameraPose pose;
  pose.vertical_field = 1e-5;
  pose.width = pose.height = 1;
  ViewOptions options;
  PupilSamplingSpec sampling;
  sampling.kind = PupilSampling::UniformPolarWeighted;
  options.pupil = PupilSampler(sampling, 0.0);
  RenderSettings settings;
  settings.samples_per_pixel = 4096;
  const GeneralCamera camera(pose, Eye::with(Prescription{}, 20e-3), RayModel::thin_lens, options);
  const RenderResult result = render(Scene(scene), camera, settings);
  // 4 σ of independent weights would be 4·√(1/3/4096) = 0.036; scrambled Sobol' points are ten times better.
  EXPECT_NEAR(result.radiance.at(0, 0)[0], 1.0f, 0.0036f);
  EXPECT_NEAR(result.variance.at(0, 0)[0], 1.0f / 3.0f, 0.01f);  // E[w²] − 1; 4 σ of independent ones is 0.019
}

}  // namespace
}  // namespace sturm
