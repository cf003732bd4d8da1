// Spreads of points over the pupil against their closed second moments (docs/theory.md#53-pupil-sampling), and Halton's
// points.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "pathtrace/sampling/pupil_sampler.h"
#include "pathtrace/sampling/sequence.h"

namespace sturm {
namespace {

struct Means {
  double weight = 0.0, square = 0.0;  ///< mean weight, weighted mean of r²
};

/// By the midpoint rule in (u, v).
Means means_of(const PupilSampler& sampler, int n = 1000) {
  Means m;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const WeightedPoint p = sampler.at((i + 0.5) / n, (k + 0.5) / n);
      m.weight += p.weight / n / n;
      m.square += p.weight * p.point.squaredNorm() / n / n;
    }
  return m;
}

/// E[r²] of a disc with the weight e^(−q r²).
double apodized_square(double q) {
  return 1.0 / q - std::exp(-q) / (1.0 - std::exp(-q));
}

PupilSampler sampler(PupilSampling kind, double q = 0.0, int rings = 8, int angle_factor = 6) {
  return {{kind, rings, angle_factor}, q};
}

constexpr double midpoint = 2e-6;  // O(1/n²), n = 1000

TEST(PupilSampler, SecondMomentsAreTheClosedForms) {
  EXPECT_NEAR(means_of(sampler(PupilSampling::UniformDisk)).square, 1.0 / 2.0, midpoint);
  EXPECT_NEAR(means_of(sampler(PupilSampling::UniformPolar)).square, 1.0 / 3.0, midpoint);
  EXPECT_NEAR(means_of(sampler(PupilSampling::UniformPolarWeighted)).square, 1.0 / 2.0, midpoint);
}

TEST(PupilSampler, RingsAreWangAndXiaos) {
  for (const auto& [rings, angle_factor] : {std::pair(1, 6), std::pair(4, 5), std::pair(8, 6)}) {
    const PupilSampler s = sampler(PupilSampling::Rings, 0.0, rings, angle_factor);
    const int points = angle_factor * rings * (rings + 1) / 2;
    Means m;
    for (int i = 0; i < points; ++i) m.square += s.at((i + 0.5) / points, 0.3).point.squaredNorm() / points;
    EXPECT_NEAR(m.square, (rings + 1.0) / (2.0 * rings), 1e-14);
  }
  // The first ring's points, counter-clockwise from +x.
  const PupilSampler s = sampler(PupilSampling::Rings, 0.0, 2, 4);
  EXPECT_LT((s.at(0.0 / 12, 0.0).point - Eigen::Vector2d(0.5, 0.0)).norm(), 1e-15);
  EXPECT_LT((s.at(1.5 / 12, 0.0).point - Eigen::Vector2d(0.0, 0.5)).norm(), 1e-15);
  EXPECT_LT((s.at(4.5 / 12, 0.0).point - Eigen::Vector2d(1.0, 0.0)).norm(), 1e-15);
}

TEST(PupilSampler, ApodizationIsTheSameWhetherByDensityOrByWeights) {
  for (const double q : {1e-3, 0.7, 4.0}) {
    const Means disc = means_of(sampler(PupilSampling::UniformDisk, q)),
                polar = means_of(sampler(PupilSampling::UniformPolarWeighted, q));
    EXPECT_NEAR(disc.weight, 1.0, 1e-10);  // 10⁶ roundings
    EXPECT_NEAR(polar.weight, 1.0, midpoint);
    // The map of the radii is steepest at the rim, by (e^q − 1)/q.
    EXPECT_NEAR(disc.square, apodized_square(q), midpoint * std::expm1(q) / q);
    EXPECT_NEAR(polar.square, apodized_square(q), 2.0 * midpoint);
    EXPECT_NEAR(means_of(sampler(PupilSampling::UniformPolar, q)).weight, 1.0, midpoint);
    double rings = 0.0;
    for (int i = 0; i < 216; ++i) rings += sampler(PupilSampling::Rings, q).at((i + 0.5) / 216, 0.0).weight / 216;
    EXPECT_NEAR(rings, 1.0, 1e-13);
  }
}

TEST(PupilSampler, StilesAndCrawfordAtThreeMillimetres) {
  // 10^(−0.05·9) = 0.3548 at the rim of a 6 mm pupil: e^(−q).
  EXPECT_NEAR(std::exp(-apodization_of(5e4, 3e-3)), 0.3548133892335755, 1e-14);
}

TEST(Halton, EveryDimensionIsStratified) {
  // A scrambled radical inverse in base b has one of its first bᵏ points in each of the bᵏ intervals.
  for (const auto& [dimension, x_base, y_base] :
       {std::tuple(0u, 2u, 3u), std::tuple(1u, 5u, 7u), std::tuple(2u, 11u, 13u)}) {
    const PixelSequence sequence(Sequence::Halton, 7, 42);
    for (const auto& [base, second] : {std::pair(x_base, false), std::pair(y_base, true)}) {
      const std::uint32_t n = base * base * (base < 4 ? base * base : 1);
      std::vector<int> hits(n, 0);
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto pair = sequence.pair(i, dimension);
        ++hits[static_cast<std::size_t>(unit_double(second ? pair.y : pair.x) * n)];
      }
      for (std::uint32_t i = 0; i < n; ++i) EXPECT_EQ(hits[i], 1) << "base " << base << ", interval " << i;
    }
  }
}

TEST(Halton, PixelsAndSeedsDiffer) {
  const auto first = PixelSequence(Sequence::Halton, 1, 0).pair(0, 0);
  EXPECT_NE(first.x, PixelSequence(Sequence::Halton, 2, 0).pair(0, 0).x);
  EXPECT_NE(first.x, PixelSequence(Sequence::Halton, 1, 1).pair(0, 0).x);
}

TEST(Halton, TheFirstPairIsUniformInThePlane) {
  // Mean of (x − ½)(y − ½) over 2⁴·3⁴ points: far below that of independent ones, 1/12/√1296 = 0.0023.
  const PixelSequence sequence(Sequence::Halton, 3, 5);
  double product = 0.0;
  for (std::uint32_t i = 0; i < 1296; ++i) {
    const auto pair = sequence.pair(i, 0);
    product += (unit_double(pair.x) - 0.5) * (unit_double(pair.y) - 0.5) / 1296;
  }
  EXPECT_LT(std::abs(product), 3e-4);
}

}  // namespace
}  // namespace sturm
