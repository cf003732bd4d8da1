// The edge-avoiding filter: what it must not change, what it must, and the closed form of its kernel.
#include <gtest/gtest.h>

#include <cmath>

#include "pathtrace/film/denoiser.h"
#include "pathtrace/film/film.h"
#include "pathtrace/sampling/owen_sobol.h"
#include "support/a_trous_noise.h"
#include "support/scene_plain.h"
#include "support/scenes.h"

namespace sturm {
namespace {

/// Images of one size: grey, with a known variance, everywhere the same surface 1 m away.
struct Inputs {
  Image radiance, mean_variance, guide_mean, guide_variance;

  Inputs(int width, int height, float value, float variance)
      : radiance(width, height, 3),
        mean_variance(width, height, 3),
        guide_mean(width, height, GuideStatistics::features),
        guide_variance(width, height, GuideStatistics::features) {
    std::fill(radiance.pixels.begin(), radiance.pixels.end(), value);
    std::fill(mean_variance.pixels.begin(), mean_variance.pixels.end(), variance);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) set_guide(x, y, 0.5f, 1.0f);
  }

  void set_guide(int x, int y, float albedo, float vergence) {
    float* const g = guide_mean.at(x, y);
    g[0] = g[1] = g[2] = albedo;
    g[5] = 1.0f;  // normal +z
    g[6] = vergence;
  }
  Image run(const DenoiseSpec& spec = {}) const {
    return denoised(DenoiserInput{radiance, mean_variance, guide_mean, guide_variance}, spec);
  }
};

/// Adds uniform noise of standard deviation `sigma` to all channels alike.
void add_noise(Image& image, float sigma) {
  for (std::size_t pixel = 0; pixel < image.pixels.size() / 3; ++pixel) {
    const float noise =
        sigma * std::sqrt(12.0f) * (unit_float(owen_sobol::mixed(static_cast<std::uint32_t>(pixel) + 77u)) - 0.5f);
    for (std::size_t k = 0; k < 3; ++k) image.pixels[3 * pixel + k] += noise;
  }
}

double mean_of(const Image& image) {
  return testing::image_mean(image, 0);
}

TEST(Denoiser, AConstantPictureStaysAsItIs) {
  const Inputs noisy_in_name(40, 30, 0.7f, 0.01f), exact(40, 30, 0.7f, 0.0f);
  for (const Inputs& inputs : {noisy_in_name, exact})
    for (const float value : inputs.run().pixels) EXPECT_NEAR(value, 0.7f, 1e-6f);
}

TEST(Denoiser, WhatHasNoVarianceIsNotTouched) {
  Inputs inputs(20, 20, 1.0f, 0.0f);
  add_noise(inputs.radiance, 0.1f);
  const Image result = inputs.run();
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    EXPECT_NEAR(result.pixels[i], inputs.radiance.pixels[i], 1e-6f);
}

TEST(Denoiser, VarianceFallsAsTheKernelsNormSays) {
  // With edges of infinite width the filter is linear: variance times (35/128)² at the first level, 70/256 being Σ of
  // the squared taps.
  EXPECT_NEAR(testing::squared_norm(1), 35.0 / 128.0, 1e-15);
  for (const int levels : {1, 2, 3}) {
    constexpr int side = 200;
    Inputs inputs(side, side, 1.0f, 0.01f);
    add_noise(inputs.radiance, 0.1f);
    DenoiseSpec spec;
    spec.levels = levels;
    spec.radiance_sigma = 1000.0;
    const Image result = inputs.run(spec);
    const int border = 2 * ((1 << levels) - 1);  // beyond it, taps lie outside of the picture
    double squares = 0.0;
    int count = 0;
    for (int y = border; y < side - border; ++y)
      for (int x = border; x < side - border; ++x, ++count)
        squares += std::pow(static_cast<double>(result.at(x, y)[0]) - 1.0, 2);
    const double norm = testing::squared_norm(levels), expected = 0.01 * norm * norm;
    // Neighbours are correlated over about 1/norm pixels each way, so there are N·norm² independent ones: 4σ of their
    // χ².
    EXPECT_NEAR(squares / count / expected, 1.0, 4.0 * std::sqrt(2.0 / (count * norm * norm))) << levels;
  }
}

/// What is left of the variance of noise on a flat field.
double noise_left_on_a_flat_field(const DenoiseSpec& spec) {
  constexpr int side = 200, border = 16;
  Inputs inputs(side, side, 2.0f, 0.04f);
  add_noise(inputs.radiance, 0.2f);
  const Image result = inputs.run(spec);
  double before = 0.0, after = 0.0;
  for (int y = border; y < side - border; ++y)
    for (int x = border; x < side - border; ++x) {
      before += std::pow(static_cast<double>(inputs.radiance.at(x, y)[0]) - 2.0, 2);
      after += std::pow(static_cast<double>(result.at(x, y)[0]) - 2.0, 2);
    }
  return after / before;
}

TEST(Denoiser, EdgeStoppingLeavesWhatItsWidthSays) {
  // Grey: Σd²/(σ²·2·Σv) = (d²/v)/(2·σ²), so that the width is radiance_sigma. 168² pixels, of which the kernel leaves
  // 168²·0.0748 independent ones: 4σ of their χ² are 12 %.
  DenoiseSpec spec;
  spec.levels = 1;
  for (const double width : {1.0, 2.0, 4.0}) {
    spec.radiance_sigma = width;
    EXPECT_NEAR(noise_left_on_a_flat_field(spec) / testing::left_with_edge_stopping(width), 1.0, 0.12) << width;
  }
  EXPECT_NEAR(testing::left_with_edge_stopping(1e3), std::pow(testing::squared_norm(1), 2),
              0.03 * 0.0748);  // 4σ of 5e4 draws: 2.5 %
}

TEST(Denoiser, EveryLevelTakesMoreNoise) {
  DenoiseSpec spec;
  double before = 1.0;
  for (spec.levels = 1; spec.levels <= DenoiseSpec{}.levels; ++spec.levels) {
    const double after = noise_left_on_a_flat_field(spec);
    EXPECT_LT(after, before) << spec.levels;
    before = after;
  }
}

TEST(Denoiser, AFlatNoisyFieldKeepsItsEnergy) {
  constexpr int side = 128;
  Inputs inputs(side, side, 2.0f, 0.04f);
  add_noise(inputs.radiance, 0.2f);
  // The noise is symmetric, so are the weights; 4σ of the field's mean.
  EXPECT_NEAR(mean_of(inputs.run()), mean_of(inputs.radiance), 4.0 * 0.2 / side);
}

/// Ratio of what is left of a step in the radiance across x = 32, noisy enough for the radiance alone not to show it.
double step_left(Inputs inputs) {
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x)
      for (int k = 0; k < 3; ++k) inputs.radiance.at(x, y)[k] += 0.2f;
  const Image result = inputs.run();
  double left = 0.0, right = 0.0;
  for (int y = 0; y < 64; ++y) {
    left += static_cast<double>(result.at(31, y)[0]) / 64;
    right += static_cast<double>(result.at(32, y)[0]) / 64;
  }
  return (right - left) / 0.2;
}

TEST(Denoiser, EdgesOfTheGuidesAreKept) {
  const Inputs flat(64, 64, 1.0f, 0.25f);
  EXPECT_LT(step_left(flat), 0.3);  // a step of 0.4 standard errors is smoothed, until the variance has fallen below it
  Inputs albedo = flat, depth = flat, normal = flat;
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x) {
      albedo.set_guide(x, y, 0.9f, 1.0f);
      depth.set_guide(x, y, 0.5f, 2.0f);
      normal.guide_mean.at(x, y)[4] = 1.0f;
      normal.guide_mean.at(x, y)[5] = 0.0f;
    }
  EXPECT_GT(step_left(albedo), 0.99);
  EXPECT_GT(step_left(depth), 0.99);
  EXPECT_GT(step_left(normal), 0.99);
}

TEST(Denoiser, ASlantedPlaneIsNoEdge) {
  Inputs plane(64, 64, 1.0f, 0.25f);  // vergence from 1 to 4 /m, affine over the picture
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) plane.set_guide(x, y, 0.5f, 1.0f + 3.0f * static_cast<float>(x) / 63.0f);
  EXPECT_LT(step_left(plane), 0.3);  // as on the flat field
}

TEST(Denoiser, NoiseOfTheGuidesIsNoEdge) {
  // What a wide pupil does: the mean albedo of a blurred pixel is noisy itself. Told so, the filter smooths; believing
  // it, it does not.
  Inputs inputs(64, 64, 1.0f, 0.25f);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const float albedo = unit_float(owen_sobol::mixed(static_cast<std::uint32_t>(64 * y + x))) - 0.5f;
      inputs.set_guide(x, y, 0.5f + albedo, 1.0f);
    }
  add_noise(inputs.radiance, 0.5f);
  const auto noise_left = [&] {
    double squares = 0.0;
    for (const float value : inputs.run().pixels) squares += std::pow(static_cast<double>(value) - 1.0, 2);
    return squares / static_cast<double>(inputs.radiance.pixels.size()) / 0.25;
  };
  const double believed = noise_left();
  for (int i = 0; i < 64 * 64; ++i)
    for (int k = 0; k < 3; ++k) inputs.guide_variance.at(i % 64, i / 64)[k] = 1.0f / 12.0f;
  EXPECT_LT(noise_left(), 0.2 * believed);
}

TEST(Denoiser, SlowTheRoomComesNearerToItsConvergedPicture) {
  const Scene scene(testing::scene_plain());
  CameraPose pose = testing::scene_plain_pose();
  pose.width = pose.height = 64;
  const EyeCamera camera(pose, testing::focused_lens(0.01, 1.05));
  RenderSettings settings;
  settings.samples_per_pixel = 1024;
  settings.seed = 99;
  const Image reference = render(scene, camera, settings).radiance;
  settings.samples_per_pixel = 16;
  settings.seed = 1;
  settings.guide_layers = true;
  const RenderResult noisy = render(scene, camera, settings);
  const auto relative_mse = [&](const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const double r = reference.pixels[i], d = static_cast<double>(image.pixels[i]) - r;
      sum += d * d / (r * r + 0.01);
    }
    return sum / static_cast<double>(image.pixels.size());
  };
  RenderResult converged = noisy;
  converged.radiance = reference;
  const double before = relative_mse(noisy.radiance), after = relative_mse(denoised(noisy, 16.0, {})),
               bias = relative_mse(denoised(converged, 16.0, {}));
  RecordProperty("relative_mse_before", std::to_string(before));
  RecordProperty("relative_mse_after", std::to_string(after));
  RecordProperty("relative_mse_of_the_bias", std::to_string(bias));
  // What the filter does to the converged picture where it expects this noise is its bias; noise adds to it in squares,
  // having no mean of its own there. Of independent noise one level leaves the share of left_with_edge_stopping, and
  // further levels take more. (Measured: 0.00766, of which 0.00348 are left, 0.00274 of them bias.)
  EXPECT_LT(after, bias + testing::left_with_edge_stopping(DenoiseSpec{}.radiance_sigma) * before);
}

}  // namespace
}  // namespace sturm
