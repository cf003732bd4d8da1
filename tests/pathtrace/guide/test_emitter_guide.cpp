// Guided camera rays change the noise of what small emitters send into the eye, not its mean: against plain sampling,
// and against the light that an emitter sends through any pupil.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pathtrace/film/render.h"
#include "pathtrace/guide/emitter_guide.h"
#include "support/lights_in_the_dark.h"
#include "support/replicates.h"
#include "support/scenes.h"

namespace sturm {
namespace {

using Eigen::Vector3f;
using testing::lamp;
using testing::lights_in_the_dark;

constexpr int size = 48;

CameraPose pose() {
  CameraPose p;
  p.position = {0.0, 0.0, 0.0};
  p.look_at = {0.0, 0.0, -1.0};
  p.up = {0.0, 1.0, 0.0};
  p.vertical_field = 0.12;
  p.width = p.height = size;
  return p;
}

EyeRays<float> eye(const Prescription& rx, double accommodation_D, RayModel model = RayModel::power_matrix) {
  return {model, Eye::with(rx, 6e-3), accommodation_D};
}

Image rendered(const Scene& scene, const EyeRays<float>& rays, bool guided, int samples, std::uint64_t seed,
               RenderCounters* counters = nullptr) {
  RenderSettings settings;
  settings.samples_per_pixel = samples;
  settings.max_bounces = 1;
  settings.seed = seed;
  settings.guide_emitters = guided;
  RenderResult result = render(scene, EyeCamera(pose(), rays), settings);
  if (counters) *counters = result.counters;
  return std::move(result.radiance);
}

/// Means over blocks of 8 × 8 pixels of one channel.
std::vector<double> block_means(const Image& image, int channel) {
  constexpr int block = 8, across = size / block;
  std::vector<double> means(across * across, 0.0);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      means[static_cast<std::size_t>(y / block * across + x / block)] +=
          static_cast<double>(image.at(x, y)[channel]) / (block * block);
  return means;
}

struct EyeCase {
  const char* name;
  EyeRays<float> rays;
};

std::vector<EyeCase> eyes() {
  return {{"myope", eye({-3.0}, 0.0)},
          {"astigmat", eye({-1.0, -3.0, 30.0}, 0.0)},
          {"focal line at 0.4 m", eye({-2.5, 4.0, 60.0}, 0.0)},  // I/d + F has the eigenvalue 0 there
          {"in focus at 0.8 m", eye({-1.25}, 0.0)},              // X = 0 for one lamp
          {"sin² rays", eye({-1.0, -3.0, 30.0}, 0.0,
                            RayModel::sin2_radial)},  // the guide's conoid is wrong for them, the mean is not
          {"accommodated", eye({1.0, -2.0, 170.0}, 2.0)}};
}

TEST(EmitterGuide, SlowTheSameMeanAsPlainSampling) {
  const Scene scene(lights_in_the_dark(10.0f));  // large enough for plain sampling to have a normal distribution
  constexpr int replicates = 16;
  for (const EyeCase& c : eyes()) {
    std::vector<std::vector<double>> plain(36), guided(36);
    for (int r = 0; r < replicates; ++r) {
      const std::vector<double> p = block_means(rendered(scene, c.rays, false, 512, 100 + r), 0),
                                g = block_means(rendered(scene, c.rays, true, 64, 900 + r), 0);
      for (std::size_t b = 0; b < p.size(); ++b) {
        plain[b].push_back(p[b]);
        guided[b].push_back(g[b]);
      }
    }
    for (std::size_t b = 0; b < plain.size(); ++b) {
      const testing::Estimate p = testing::Estimate::of(plain[b]), g = testing::Estimate::of(guided[b]);
      // Welch's t with at least 15 degrees of freedom: |t| > 6.5 has a probability of 1e-5, 216 tests together 0.2 %.
      EXPECT_LE(std::abs(p.mean - g.mean), 6.5 * std::hypot(p.standard_error, g.standard_error) + 1e-7)
          << c.name << " block " << b;
    }
  }
}

TEST(EmitterGuide, NothingIsLostWhereverTheFocalLinesLie) {
  // Whatever the blur, the sum over the image is the light that comes through the pupil: radiance × solid angle, per
  // pixel's solid angle. A sphere of radius R at d covers π (R/d)² of slope space, but for (R/d)² of that.
  for (const EyeCase& c : eyes()) {
    SceneDescription d;
    d.materials = {testing::lambertian(Vector3f::Zero(), {1e4f, 1e4f, 1e4f})};
    d.spheres = {{{0.001f, -0.002f, -0.4f}, 0.00004f, 0}};
    const Scene scene(d);
    RenderCounters counters;
    std::vector<double> sums;
    for (int r = 0; r < 16; ++r)
      sums.push_back(testing::image_mean(rendered(scene, c.rays, true, 64, 500 + r, &counters), 1) * size * size);
    const testing::Estimate sum = testing::Estimate::of(sums);
    const double slope = pixel_slope(pose()), expected = 1e4 * std::numbers::pi * 1e-8 / (slope * slope);
    EXPECT_NEAR(sum.mean, expected, 5.0 * sum.standard_error + 2e-5 * expected) << c.name;
    if (c.rays.model() == RayModel::sin2_radial) continue;  // their rays do not go where wavefront theory says
    // Plain sampling would hit the sphere 0.3 times in such an image: a standard error of 45 %.
    EXPECT_LT(sum.standard_error, 0.06 * expected) << c.name;
    EXPECT_GT(counters.guided_hits, counters.guided_rays / 20) << c.name;
  }
}

TEST(EmitterGuide, LessNoiseForTheSameSamples) {
  const Scene scene(lights_in_the_dark());
  const EyeRays<float> rays = eye({-3.0}, 0.0);
  const auto noise = [&](bool guided) {
    double squares = 0.0;
    for (int pair = 0; pair < 4; ++pair) {
      const Image a = rendered(scene, rays, guided, 16, 10 + 2 * pair),
                  b = rendered(scene, rays, guided, 16, 11 + 2 * pair);
      for (std::size_t i = 0; i < a.pixels.size(); ++i)
        squares += std::pow(static_cast<double>(a.pixels[i] - b.pixels[i]), 2);
    }
    return squares;
  };
  EXPECT_LT(noise(true), 0.02 * noise(false));
}

TEST(EmitterGuide, DoesNothingWhereItCannotHelp) {
  SceneDescription d = lights_in_the_dark();
  const Scene scene(d);
  EXPECT_TRUE(EmitterGuide(scene, EyeCamera(pose(), testing::pinhole_rays())).empty());
  // A large lamp that most of the pupil sees at a time.
  d.meshes = {testing::parallelogram({1, -1, -4}, {-2, 0, 0}, {0, 2, 0}, 1)};
  d.spheres.clear();
  EXPECT_TRUE(EmitterGuide(Scene(d), EyeCamera(pose(), eye({-3.0}, 0.0))).empty());
  // Behind the eye.
  d.meshes = {lamp({0, 0, 1}, 0.001f, 1)};
  const Scene behind(d);
  EXPECT_TRUE(EmitterGuide(behind, EyeCamera(pose(), eye({-3.0}, 0.0))).empty());
  RenderCounters counters;
  EXPECT_EQ(rendered(behind, eye({-3.0}, 0.0), true, 16, 1, &counters).pixels,
            rendered(behind, eye({-3.0}, 0.0), false, 16, 1).pixels);
  EXPECT_EQ(counters.guided_rays, 0u);
}

TEST(EmitterClusters, TrianglesThatHangTogether) {
  const Scene scene(lights_in_the_dark());
  const EmitterClusters clusters(scene.lights());
  EXPECT_EQ(clusters.clusters().size(), 4u);  // two lamps, two spheres
  for (const EmitterCluster& c : clusters.clusters()) EXPECT_LT(c.radius, 0.00041f);
  EXPECT_EQ(clusters.cluster_of(0), clusters.cluster_of(7));
  EXPECT_NE(clusters.cluster_of(7), clusters.cluster_of(8));
}

TEST(EmitterGuide, DensityIsThatOfTheProposals) {
  // The proposals' mean of 1/pdf is the area of the region that they fill: its rectangle within the pupil.
  const Scene scene(lights_in_the_dark());
  const EyeCamera camera(pose(), eye({-1.0, -3.0, 30.0}, 0.0));
  const EmitterGuide guide(scene, camera);
  ASSERT_FALSE(guide.empty());
  std::vector<GuidedTarget> targets;
  int pixels = 0, proposals = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      guide.find_targets(camera.pixel(x, y), targets);
      float sum = 0.0f;
      for (const GuidedTarget& t : targets) sum += t.probability;
      if (!targets.empty()) {
        EXPECT_NEAR(sum, 1.0f, 1e-5f);
        ++pixels;
      }
      for (const GuidedTarget& t : targets) {
        const auto place =
            guide.place(camera.pixel(x, y), {static_cast<float>(x) + 0.3f, static_cast<float>(y) + 0.6f});
        ASSERT_TRUE(place);
        const auto region = guide.region(t.cluster, *place);
        if (!region) continue;
        for (const float u : {0.01f, 0.5f, 0.99f}) {
          const Eigen::Vector2f p = region->point(u, 1.0f - u);
          if (!guide.ray(*place, p)) continue;
          ++proposals;
          EXPECT_LE(p.norm(), 3e-3f * 1.0001f);
          EXPECT_FLOAT_EQ(region->proposed_pdf(), region->pdf(p));
        }
      }
    }
  EXPECT_GT(proposals, 60);
  EXPECT_GT(pixels, 20);
}

}  // namespace
}  // namespace sturm
