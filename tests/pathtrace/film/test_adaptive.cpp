// Adaptive sampling moves samples, not means. The plain rule, to go on where a pixel's own samples differ, is shown to
// be wrong.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "pathtrace/film/adaptive_render.h"
#include "support/function_source.h"
#include "support/replicates.h"
#include "support/same_bytes.h"
#include "support/scene_plain.h"
#include "support/scenes.h"
#include "support/student.h"

namespace sturm {
namespace {

using testing::same_bytes;

using testing::FunctionSource;

RenderSettings adaptive_settings(double relative_error, int limit) {
  RenderSettings settings;
  settings.samples_per_pixel = limit;
  settings.relative_error = relative_error;
  settings.adaptive.emplace();
  return settings;
}

/// Probability that replicates of this mean lie as far from it (one-sample t-test).
double p_value(const std::vector<double>& replicates, double mean) {
  const testing::Estimate e = testing::Estimate::of(replicates);
  return testing::student_two_sided((e.mean - mean) / e.standard_error, static_cast<double>(replicates.size()) - 1.0);
}

/// Level of one of `tests` tests that are to fail with probability α together (Šidák 1967).
double sidak(double alpha, int tests) {
  return 1.0 - std::pow(1.0 - alpha, 1.0 / tests);
}

constexpr int side = 16, tiles = 4, replicates = 500;
constexpr float rarity = 1e-3f;  // half a half of a tile's first pass (1024 samples) sees one event on average

FunctionSource rare_events(std::uint64_t seed, Sequence sequence = Sequence::Independent) {
  return {side, side, sequence, seed, [](int, int, float u, float) { return u < rarity ? 1.0f / rarity : 0.0f; }};
}

double tile_mean(const Image& image, int tile) {
  double sum = 0.0;
  for (int y = tile / 2 * 8; y < tile / 2 * 8 + 8; ++y)
    for (int x = tile % 2 * 8; x < tile % 2 * 8 + 8; ++x) sum += static_cast<double>(image.at(x, y)[0]);
  return sum / 64.0;
}

TEST(AdaptiveRender, RareEventsKeepTheirMean) {
  std::vector<std::vector<double>> means(tiles);
  std::uint64_t fewest = ~std::uint64_t{0}, most = 0;
  for (std::uint64_t seed = 0; seed < replicates; ++seed) {
    const RenderResult result = render_to_error(rare_events(seed), adaptive_settings(0.3, 512));
    for (int t = 0; t < tiles; ++t) means[static_cast<std::size_t>(t)].push_back(tile_mean(result.radiance, t));
    fewest = std::min(fewest, result.passes.samples_kept);
    most = std::max(most, result.passes.samples_kept);
  }
  EXPECT_LT(2 * fewest, most);  // there was something to decide
  for (int t = 0; t < tiles; ++t)
    EXPECT_GT(p_value(means[static_cast<std::size_t>(t)], 1.0), sidak(1e-3, tiles)) << "tile " << t;
}

TEST(AdaptiveRender, ThePlainRuleWouldFailThisTest) {
  // A tile whose own first 32 samples per pixel show no event stops there; the others go on to 512.
  std::vector<double> means;
  for (std::uint64_t seed = 0; seed < replicates; ++seed) {
    const FunctionSource source = rare_events(seed);
    PixelStatistics tile;
    FirstHitStatistics first_hit;
    RenderCounters counters;
    const auto add = [&](std::uint32_t first, std::uint32_t count) {
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) source.add_samples(x, y, {0, first, count}, {tile, first_hit}, counters);
    };
    add(0, 32);
    if (tile.variance(0) > 0.0) add(32, 480);
    means.push_back(tile.mean(0));
  }
  // Poisson with λ = 2.048 events in the first pass: e^−λ of the tiles keep 0. E = 1 − e^−λ·(1 − 32/512) = 0.879.
  const testing::Estimate e = testing::Estimate::of(means);
  EXPECT_NEAR(e.mean, 1.0 - std::exp(-2.048) * (1.0 - 1.0 / 16.0), 4.0 * e.standard_error);
  EXPECT_LT(p_value(means, 1.0), 1e-9);
}

TEST(AdaptiveRender, TheMeasuredErrorIsTheError) {
  // Every second tile is 8 times as noisy. The halves' difference estimates the squared error without bias whatever has
  // been decided.
  std::vector<double> measured, actual;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const FunctionSource source(32, 16, Sequence::Independent, seed, [](int x, int, float u, float) {
      return 1.0f + (x / 8 % 2 ? 0.8f : 0.1f) * (u - 0.5f);
    });
    const RenderResult result = render_to_error(source, adaptive_settings(0.01, 4096));
    measured.push_back(*result.passes.measured_relative_error * *result.passes.measured_relative_error);
    double squares = 0.0;
    for (const float value : result.radiance.pixels)
      squares += (static_cast<double>(value) - 1.0) * (static_cast<double>(value) - 1.0) / 1.01;
    actual.push_back(squares / static_cast<double>(result.radiance.pixels.size()));
  }
  const testing::Estimate m = testing::Estimate::of(measured), a = testing::Estimate::of(actual);
  EXPECT_NEAR(m.mean, a.mean, 4.0 * std::hypot(m.standard_error, a.standard_error));
  EXPECT_LT(a.mean, 1e-4);
  EXPECT_GT(a.mean, 0.25e-4);  // doubling overshoots by 2 at most, deciding by tiles twice that
}

TEST(AdaptiveRender, TheErrorOfLowDiscrepancySamplesIsNotOverestimated) {
  // Of a smooth function, scrambled Sobol' points have an error that falls much faster than s²/N.
  double measured = 0.0, actual = 0.0, naive = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FunctionSource source(16, 16, Sequence::Sobol, seed, [](int, int, float u, float v) { return 4.0f * u * v; });
    const RenderResult result = render_to_error(source, adaptive_settings(1e-6, 256));
    for (std::size_t i = 0; i < result.radiance.pixels.size(); ++i) {
      const double error = static_cast<double>(result.radiance.pixels[i]) - 1.0;
      actual += error * error;
      measured += static_cast<double>(result.mean_variance.pixels[i]);
      naive += static_cast<double>(result.variance.pixels[i]) / 256.0;
    }
  }
  // 5120 pixels with one degree of freedom each: a standard error of 2 % on both sides, more for the tails of these
  // errors.
  EXPECT_NEAR(measured / actual, 1.0, 0.12);
  EXPECT_GT(naive, 5.0 * actual);
}

TEST(AdaptiveRender, CountsWhatItSpendsAndSaves) {
  const FunctionSource source(20, 13, Sequence::Sobol, 1, [](int x, int, float u, float) {
    return x < 8 ? 1.0f : 1.0f + 2.0f * (u < 0.5f ? -0.4f : 0.4f) * u;
  });
  const RenderResult result = render_to_error(source, adaptive_settings(0.002, 600));
  const PassSummary& passes = result.passes;
  EXPECT_EQ(passes.tiles, 6u);  // 3 across, 2 down; those at the edges are smaller
  double kept = 0.0;
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 20; ++x) {
      const float samples = *result.samples.at(x, y);
      kept += static_cast<double>(samples);
      EXPECT_EQ(samples, *result.samples.at(x / 8 * 8, y / 8 * 8));
      if (x < 8) {
        EXPECT_EQ(samples, 32.0f);
      }
      EXPECT_LE(samples, 600.0f);
    }
  EXPECT_EQ(static_cast<std::uint64_t>(kept), passes.samples_kept);
  EXPECT_GE(passes.samples_spent, passes.samples_kept);
  EXPECT_EQ(passes.samples_spent, result.counters.camera.launched);
  EXPECT_EQ(passes.samples_spent + passes.samples_saved, 20u * 13u * 600u);
}

/// Every sample uniform in [0, 2).
FunctionSource noise_everywhere() {
  return {side, side, Sequence::Independent, 1, [](int, int, float u, float) { return 2.0f * u; }};
}

TEST(AdaptiveRender, ALimitThatIsTooLowIsTold) {
  const RenderResult result = render_to_error(noise_everywhere(), adaptive_settings(1e-3, 71));  // 4 streams of 17
  EXPECT_EQ(result.passes.samples_kept, 68u * 256u);
  EXPECT_EQ(result.passes.tiles_converged, 0u);
  EXPECT_GT(*result.passes.measured_relative_error, 1e-3);
}

TEST(AdaptiveRender, WithoutTilesThePictureHasOneNumberOfSamples) {
  RenderSettings settings = adaptive_settings(0.05, 4096);
  settings.adaptive.reset();
  const FunctionSource source(16, 16, Sequence::Independent, 3,
                              [](int x, int, float u, float) { return x < 8 ? 1.0f : 2.0f * u; });
  const RenderResult result = render_to_error(source, settings);
  // Half the picture has σ² = 1/3: 1/6/n ≤ 0.0025 at n ≥ 67, so 128. The two halves may differ by one doubling.
  for (const float samples : result.samples.pixels) EXPECT_EQ(samples, result.samples.pixels[0]);
  EXPECT_GE(result.samples.pixels[0], 96.0f);
  EXPECT_LE(result.samples.pixels[0], 128.0f);
  EXPECT_EQ(result.passes.tiles_converged, result.passes.tiles);
}

TEST(AdaptiveRender, MayBeInterrupted) {
  RenderSettings settings = adaptive_settings(1e-4, 4096);
  int calls = 0;
  Image last;
  settings.after_pass = [&](const PassReport& report) {
    last = report.picture_so_far();
    return ++calls < 3;
  };
  const RenderResult result = render_to_error(noise_everywhere(), settings);
  EXPECT_TRUE(result.passes.interrupted);
  EXPECT_EQ(result.passes.samples_kept, 128u * 256u);  // streams of 8, 16, 32
  EXPECT_EQ(last.pixels, result.radiance.pixels);
}

TEST(AdaptiveRender, TheSameBitsForAnyNumberOfThreads) {
  const Scene scene(testing::scene_plain());
  CameraPose pose = testing::scene_plain_pose();
  pose.width = 50;
  pose.height = 37;
  RenderSettings settings = adaptive_settings(0.03, 256);
  settings.guide_layers = true;
  const auto picture = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    return render(scene, EyeCamera(pose, testing::focused_lens(0.02, 1.05)), settings);
  };
  const RenderResult one = picture(1);
  EXPECT_NE(*std::min_element(one.samples.pixels.begin(), one.samples.pixels.end()),
            *std::max_element(one.samples.pixels.begin(), one.samples.pixels.end()));
  settings.after_pass = [](const PassReport&) { return true; };  // nor does a watched rendering differ
  for (const int threads : {2, 3}) {
    const RenderResult other = picture(threads);
    EXPECT_TRUE(same_bytes(one.radiance, other.radiance));
    EXPECT_TRUE(same_bytes(one.variance, other.variance));
    EXPECT_TRUE(same_bytes(one.mean_variance, other.mean_variance));
    EXPECT_TRUE(same_bytes(one.samples, other.samples));
    EXPECT_TRUE(same_bytes(one.guide_mean, other.guide_mean));
    EXPECT_EQ(one.passes.samples_spent, other.passes.samples_spent);
    EXPECT_EQ(one.passes.measured_relative_error, other.passes.measured_relative_error);
  }
}

TEST(AdaptiveRender, SlowALampOutOfFocusHasTheMeanOfAFixedNumberOfSamples) {
  // A small lamp before a grey wall: its blur is met by one sample in 150, and nothing guides them.
  SceneDescription description;
  description.materials = {testing::lambertian({0.5f, 0.5f, 0.5f}),
                           testing::lambertian(Eigen::Vector3f::Zero(), {400.0f, 300.0f, 200.0f})};
  description.meshes = {testing::parallelogram({-3, -3, -4}, {6, 0, 0}, {0, 6, 0}, 0)};
  description.spheres = {{{0.0f, 0.0f, -0.4f}, 0.0001f, 1}, {{1.0f, 1.5f, -2.0f}, 0.1f, 1}};
  const Scene scene(description);
  CameraPose pose;
  pose.vertical_field = 0.1;
  pose.width = pose.height = 32;
  const EyeCamera camera(pose, {RayModel::power_matrix, Eye::with({}, 6e-3), 0.0});
  // The means of single pictures are skewed (a half that has missed the lamp stops the other early), which t only
  // forgets over many.
  constexpr int blocks = 16, pictures = 240;
  std::vector<std::vector<double>> fixed(blocks), adaptive(blocks);
  const auto add = [&](const Image& image, std::vector<std::vector<double>>& to) {
    for (int b = 0; b < blocks; ++b) {
      double sum = 0.0;
      for (int i = 0; i < 64; ++i) sum += static_cast<double>(image.at(b % 4 * 8 + i % 8, b / 4 * 8 + i / 8)[0]);
      to[static_cast<std::size_t>(b)].push_back(sum / 64.0);
    }
  };
  for (int r = 0; r < pictures; ++r) {
    RenderSettings settings = adaptive_settings(0.1, 2048);
    settings.seed = 1000 + static_cast<std::uint64_t>(r);
    settings.max_bounces = 1;
    add(render(scene, camera, settings).radiance, adaptive);
    settings.relative_error.reset();
    settings.samples_per_pixel = 512;
    settings.seed += 1000;
    add(render(scene, camera, settings).radiance, fixed);
  }
  for (std::size_t b = 0; b < blocks; ++b) {
    const testing::Estimate f = testing::Estimate::of(fixed[b]), a = testing::Estimate::of(adaptive[b]);
    const double t = (a.mean - f.mean) / std::hypot(a.standard_error, f.standard_error);
    EXPECT_GT(testing::student_two_sided(t, pictures - 1.0), sidak(1e-3, blocks))
        << "block " << b << ": " << a.mean << ", " << f.mean;
  }
}

}  // namespace
}  // namespace sturm
