// The estimate of a bias under noise, on pictures whose bias and noise are chosen.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "compare/images/paired_bias.h"

namespace sturm {
namespace {

constexpr int side = 16;

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
          image.at(x, y)[c] =
              static_cast<float>(value + (x < side / 2 ? tilt : -tilt) + (noise > 0.0 ? normal(generator) : 0.0));
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
  double sum = 0.0, squares = 0.0;
  constexpr int trials = 100;
  for (unsigned t = 0; t < trials; ++t) {
    const PairedBias bias = paired_bias(noisy(8, 0.6, 0.3, 100 + t), noisy(8, 0.5, 0.3, 9000 + t));
    sum += bias.mean_square;
    squares += std::pow((bias.mean_square - 0.01) / bias.standard_error, 2);
    EXPECT_GT(bias.z, 3.0);  // about 6: 0.01 over (0.18/√768 ⊕ 0.1·√(2·0.18/768))/√28
  }
  // Its error: 2·0.1·√(0.18/8/768) ⊕ 0.18·√(2/(8·7))/√768 = 1.08e-3 ⊕ 1.23e-3; 4 σ of the mean of 100.
  EXPECT_NEAR(sum / trials, 0.01, 4.0 * 1.64e-3 / std::sqrt(trials));
  // Student's t with 7 degrees of freedom has the variance 1.4; the jackknife's variance is up to twice too large
  // [Efron & Stein 1981].
  EXPECT_GT(squares / trials, 0.5);
  EXPECT_LT(squares / trials, 2.0);
}

TEST(PairedBias, WithoutABiasZIsOfUnitSize) {
  double sum = 0.0, squares = 0.0;
  constexpr int trials = 100;
  for (unsigned t = 0; t < trials; ++t) {
    const double z = paired_bias(noisy(6, 0.5, 0.3, 1000 + t), noisy(6, 0.5, 0.3, 5000 + t)).z;
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / trials, 0.0, 4.0 / std::sqrt(trials));  // 4 σ
  EXPECT_NEAR(squares / trials, 1.17,
              4.0 * std::sqrt(3.6 / trials));  // t² with 14 degrees of freedom: mean 1.17, variance 3.6; 4 σ
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
