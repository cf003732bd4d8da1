// The estimate of a bias under noise, on pictures whose bias and noise are chosen.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "compare/paired_bias.h"

namespace sturm {
namespace {

constexpr int side = 32;

/// Pictures of a constant plus normal noise; `tilt` adds a pattern of that amplitude: + left, − right.
std::vector<Image> noisy(int count, double value, double noise, unsigned seed, double tilt = 0.0) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, noise);
  std::vector<Image> images;
  for (int r = 0; r < count; ++r) {
    Image image(side, side, 3);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int c = 0; c < 3; ++c)
          image.at(x, y)[c] = static_cast<float>(value + (x < side / 2 ? tilt : -tilt) + (noise > 0.0 ? normal(generator) : 0.0));
    images.push_back(std::move(image));
  }
  return images;
}

TEST(PairedBias, WithoutNoiseItIsTheMeanSquare) {
  const PairedBias bias = paired_bias(noisy(3, 0.75, 0.0, 1, 0.5), noisy(3, 0.5, 0.0, 2));
  EXPECT_NEAR(bias.mean_square, 0.3125, 1e-12);  // the mean of 0.75² and (−0.25)²
  EXPECT_NEAR(bias.standard_error, 0.0, 1e-12);
}

TEST(PairedBias, NoiseAddsNothing) {
  // Noise of 0.3 in both: the plain mean square of the difference of the means would be 0.01 + 2·0.09/8 = 0.0325.
  const PairedBias bias = paired_bias(noisy(8, 0.6, 0.3, 3), noisy(8, 0.5, 0.3, 4));
  EXPECT_NEAR(bias.mean_square, 0.01, 4.0 * bias.standard_error);  // 4 σ
  // Error of a mean of 3072 values of variance 0.18/8 about 0.1, times 2·0.1.
  EXPECT_NEAR(bias.standard_error, 0.2 * std::sqrt(0.18 / 8 / 3072),
              0.7 * 0.2 * std::sqrt(0.18 / 8 / 3072));  // 7 degrees of freedom, 2.7 σ
  EXPECT_GT(bias.z, 20.0);
}

TEST(PairedBias, WithoutABiasZIsOfUnitSize) {
  double sum = 0.0, squares = 0.0;
  constexpr int trials = 200;
  for (unsigned t = 0; t < trials; ++t) {
    const double z = paired_bias(noisy(6, 0.5, 0.3, 1000 + t), noisy(6, 0.5, 0.3, 5000 + t)).z;
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / trials, 0.0, 4.0 / std::sqrt(trials));            // 4 σ
  EXPECT_NEAR(squares / trials, 1.0, 4.0 * std::sqrt(2.0 / trials));  // 4 σ of the mean of χ² with 1 degree of freedom
}

TEST(PairedBias, NeedsThreeOfEachAndOneSize) {
  EXPECT_THROW(paired_bias(noisy(2, 0, 0, 1), noisy(2, 0, 0, 1)), std::invalid_argument);
  EXPECT_THROW(paired_bias(noisy(4, 0, 0, 1), noisy(3, 0, 0, 1)), std::invalid_argument);
  std::vector<Image> other = noisy(3, 0, 0, 1);
  other[2] = Image(2, 2, 3);
  EXPECT_THROW(paired_bias(noisy(3, 0, 0, 1), other), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
