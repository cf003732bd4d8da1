// Where the error of a predicted picture comes from: pictures with known noise and known errors.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/statistics/equal_error.h"
#include "compare/studies/agreement/agreement_measures.h"

namespace sturm {
namespace {

constexpr int side = 96;

/// A smooth picture with details of a few pixels.
Image truth() {
  Image image(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<float>(0.5 + 0.2 * std::sin(0.6 * x + c) * std::cos(0.5 * y));
  return image;
}

Image with_noise(Image image, double sigma, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<float> normal(0.0f, static_cast<float>(sigma));
  for (float& v : image.pixels) v += normal(random);
  return image;
}

std::vector<Image> replicates(const Image& image, double sigma, int count, unsigned seed) {
  std::vector<Image> result;
  for (int r = 0; r < count; ++r) result.push_back(with_noise(image, sigma, seed + static_cast<unsigned>(r)));
  return result;
}

/// The truth with a constant offset in its left quarter.
Image off_on_the_left(double offset) {
  Image image = truth();
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side / 4; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] += static_cast<float>(offset);
  return image;
}

Image left_quarter() {
  Image mask(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side / 4; ++x) *mask.at(x, y) = 1.0f;
  return mask;
}

TEST(AgreementMeasures, SquaresAreSplitIntoNoiseAndMethod) {
  const double reference_sigma = 0.04, own_sigma = 0.03, offset = 0.02;
  const ReplicatePictures reference(replicates(truth(), reference_sigma, 4, 1)),
      predicted(replicates(off_on_the_left(offset), own_sigma, 4, 100));
  const PredictionErrors errors(reference, predicted);
  const ErrorParts whole = errors.within(nullptr);
  // χ² with 3 degrees of freedom for each of 3 · 96² values: relative standard error √(2/82944) = 0.5 %; 4 of them.
  const double noise = 4.0 * std::sqrt(2.0 / (3.0 * side * side * 3.0));
  EXPECT_NEAR(whole.reference_noise / (reference_sigma * reference_sigma / 4.0), 1.0, noise);
  EXPECT_NEAR(whole.prediction_noise / (own_sigma * own_sigma), 1.0, noise);
  // A quarter of the pixels: 0.25 · 4e-4. What is subtracted leaves 0.5 % of the noise's 1.3e-3.
  EXPECT_NEAR(whole.method(), 0.25 * offset * offset, 4.0 * 0.005 * 1.3e-3);
  const Image mask = left_quarter();
  const ErrorParts left = errors.within(&mask);
  EXPECT_EQ(left.pixels, static_cast<std::size_t>(side * side / 4));
  EXPECT_NEAR(left.method(), offset * offset, 4.0 * 0.01 * 1.3e-3);  // a quarter of the pixels, twice the error
  // The offset times the mean noise of the reference in 6912 values, twice: 2 · 0.02 · 0.02/83 = 1e-5 of 2 · 0.036 ·
  // RMSE; 4σ.
  EXPECT_NEAR(left.rmse.value, std::sqrt(own_sigma * own_sigma + offset * offset), 6e-4);
}

TEST(AgreementMeasures, SimilarityIsSplitAsPicturesWithoutNoiseWouldHaveIt) {
  const double reference_sigma = 0.03, own_sigma = 0.015;
  const Image distorted = off_on_the_left(0.05);
  const ReplicatePictures reference(replicates(truth(), reference_sigma, 6, 1)),
      predicted(replicates(distorted, own_sigma, 6, 100));
  const SimilarityLoss loss = PredictionErrors(reference, predicted).similarity_loss();
  const double clean = ssim(distorted, truth()).mean;
  double own = 0.0;
  for (const Image& image : predicted.images()) own += ssim(image, truth()).mean / 6.0;
  // Extrapolation is linear in the variance v/V over that of the picture, 2e-4/2e-2 at the most: v²/V² is left of it, 1
  // % of the loss.
  EXPECT_NEAR(loss.method, 1.0 - clean, 0.02 * loss.total);
  EXPECT_NEAR(loss.prediction_noise, clean - own, 0.02 * loss.total);
  EXPECT_NEAR(loss.reference_noise, loss.total - (1.0 - own), 0.02 * loss.total);
  EXPECT_NEAR(loss.total, loss.method + loss.prediction_noise + loss.reference_noise, 1e-12);
}

TEST(EqualError, FollowsThePowerLawAndTheLineOfTime) {
  // v = 0.64 n^-1.5, t = 0.1 s + 0.01 s n.
  const NoiseOverTime path_tracing({16.0, 0.26, 0.01}, {64.0, 0.74, 0.00125});
  EXPECT_NEAR(*path_tracing.order(), 1.5, 1e-12);
  EXPECT_NEAR(*path_tracing.samples_for(0.64 / 1000.0), 100.0, 1e-9);
  EXPECT_NEAR(*path_tracing.variance_of(100.0), 0.64 / 1000.0, 1e-15);
  EXPECT_NEAR(path_tracing.seconds_for(100.0), 1.1, 1e-12);
  EXPECT_NEAR(path_tracing.seconds_per_sample(), 0.01, 1e-12);
  EXPECT_FALSE(path_tracing.samples_for(-1e-6).has_value());  // below the reference's noise
  EXPECT_FALSE(NoiseOverTime({16.0, 0.2, 1e-3}, {64.0, 0.8, 1e-3}).order().has_value());
  // A line that would start below zero: in proportion.
  EXPECT_NEAR(NoiseOverTime({16.0, 0.1, 0.01}, {64.0, 0.8, 0.00125}).seconds_for(16.0), 0.2, 1e-12);
}

}  // namespace
}  // namespace sturm
