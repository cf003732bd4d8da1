#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "pathtrace/sampling/owen_sobol.h"
#include "pathtrace/sampling/sequence.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/replicates.h"

namespace sturm {
namespace {

/// The upper `bits` bits, as a cell number.
std::uint32_t cell(std::uint32_t x, int bits) {
  return bits == 0 ? 0u : x >> (32 - bits);
}

/// Whether samples first … first + 2^k − 1 hit every elementary interval of area 2^−k exactly once, in all k + 1
/// shapes.
bool is_net(std::uint32_t key, std::uint32_t first, int k) {
  const std::uint32_t count = 1u << k;
  for (int x_bits = 0; x_bits <= k; ++x_bits) {
    std::vector<bool> hit(count, false);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto p = owen_sobol::pair(first + i, key);
      const std::uint32_t interval = (cell(p.x, x_bits) << (k - x_bits)) | cell(p.y, k - x_bits);
      if (hit[interval]) return false;
      hit[interval] = true;
    }
  }
  return true;
}

// That makes a (0, 2)-sequence of every key.
RC_GTEST_PROP(OwenSobol, EveryAlignedBlockIsANet, ()) {
  const int k = *rc::gen::inRange(0, 9);
  RC_ASSERT(is_net(*rc::gen::arbitrary<std::uint32_t>(), (1u << k) * *rc::gen::inRange(0u, 1000u), k));
}

TEST(OwenSobol, KeysWithSpecialBitsGiveNetsToo) {
  for (std::uint32_t key : {0u, 1u, 2u, 0x80000000u, 0xffffffffu, 0x12345678u, 0xdeadbeefu})
    for (int k = 0; k <= 8; ++k) EXPECT_TRUE(is_net(key, 0, k)) << "key " << key << " k " << k;
}

RC_GTEST_PROP(OwenSobol, SingleIsStratified, ()) {
  const auto key = *rc::gen::arbitrary<std::uint32_t>();
  const int k = *rc::gen::inRange(0, 9);
  const std::uint32_t count = 1u << k, first = count * *rc::gen::inRange(0u, 1000u);
  std::vector<int> hits(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) ++hits[cell(owen_sobol::single(first + i, key), k)];
  for (int n : hits) RC_ASSERT(n == 1);
}

// Unbiased: over the keys, one sample is uniform over the square …
TEST(OwenSobol, EachSampleIsUniformOverTheKeys) {
  for (std::uint32_t sample : {0u, 1u, 7u, 1000u}) {
    std::vector<int> counts(256, 0);
    for (std::uint32_t key = 0; key < (1u << 16); ++key) {
      const auto p = owen_sobol::pair(sample, owen_sobol::mixed(key));
      ++counts[(cell(p.x, 4) << 4) | cell(p.y, 4)];
    }
    EXPECT_LT(testing::chi_squared(counts, 256.0), testing::chi_squared_limit(255)) << sample;
  }
}

// … and two samples are tied by nothing but their strata: 0 and 1 lie in different halves of x, and the next four bits
// know nothing of each other.
TEST(OwenSobol, NeighboursAreIndependentWithinTheirStrata) {
  std::vector<int> counts(256, 0);
  for (std::uint32_t key = 0; key < (1u << 16); ++key) {
    const std::uint32_t k = owen_sobol::mixed(key);
    const std::uint32_t a = owen_sobol::pair(0, k).x, b = owen_sobol::pair(1, k).x;
    ASSERT_NE(a >> 31, b >> 31);
    ++counts[(((a >> 27) & 15u) << 4) | ((b >> 27) & 15u)];
  }
  EXPECT_LT(testing::chi_squared(counts, 256.0), testing::chi_squared_limit(255));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  double sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sa += a[i], sb += b[i];
    aa += a[i] * a[i], bb += b[i] * b[i], ab += a[i] * b[i];
  }
  return (ab - sa * sb / n) / std::sqrt((aa - sa * sa / n) * (bb - sb * sb / n));
}

TEST(OwenSobol, PixelsAndDimensionsAreDecorrelated) {
  constexpr std::uint32_t samples = 4096;
  std::vector<std::vector<double>> columns;
  for (std::uint64_t seed : {1ull, 2ull, 1ull << 32})
    for (std::uint32_t pixel : {0u, 1u, 256u})
      for (std::uint32_t dimension : {0u, 1u, 2u}) {
        std::vector<double> x, y;
        const PixelSequence sequence(Sequence::Sobol, seed, pixel);
        for (std::uint32_t i = 0; i < samples; ++i) {
          const auto p = sequence.pair(i, dimension);
          x.push_back(unit_double(p.x));
          y.push_back(unit_double(p.y));
        }
        columns.push_back(x);
        columns.push_back(y);
      }
  // 1431 pairs; the standard deviation of a correlation is 1/√4096.
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_LT(std::abs(correlation(columns[i], columns[j])), 5.0 / 64.0) << i << " " << j;
}

RC_GTEST_PROP(PixelSequence, ASampleIsAFunctionOfItsAddressAlone, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto pixel = *rc::gen::arbitrary<std::uint32_t>();
  const auto sample = *rc::gen::arbitrary<std::uint32_t>(), dimension = *rc::gen::inRange(0u, 60u);
  for (Sequence kind : {Sequence::Sobol, Sequence::Independent}) {
    const PixelSequence used(kind, seed, pixel), fresh(kind, seed, pixel);
    for (std::uint32_t i = 0; i < 5; ++i) (void)used.pair(i, i);
    RC_ASSERT(used.pair(sample, dimension).x == fresh.pair(sample, dimension).x);
    RC_ASSERT(used.pair(sample, dimension).y == fresh.pair(sample, dimension).y);
    RC_ASSERT(used.single(sample, dimension) == fresh.single(sample, dimension));
    RC_ASSERT(PixelSequence(kind, seed + 1, pixel).pair(sample, dimension).x != used.pair(sample, dimension).x ||
              PixelSequence(kind, seed + 1, pixel).pair(sample, dimension).y != used.pair(sample, dimension).y);
  }
}

TEST(PixelSequence, ABlockHasThePairsOfItsSamples) {
  for (Sequence kind : {Sequence::Sobol, Sequence::Halton, Sequence::Independent}) {
    const PixelSequence sequence(kind, 7, 23);
    for (const std::uint32_t first : {0u, 3u, 4096u})
      for (const std::uint32_t dimension : {dimension::film, dimension::lens, dimension::guided_lens}) {
        const auto block = sequence.pairs<16>(first, dimension);
        for (std::uint32_t i = 0; i < 16; ++i) {
          ASSERT_EQ(block.x[i], sequence.pair(first + i, dimension).x) << first << " " << dimension << " " << i;
          ASSERT_EQ(block.y[i], sequence.pair(first + i, dimension).y) << first << " " << dimension << " " << i;
        }
      }
  }
}

TEST(PixelSequence, IndependentNumbersAreUniform) {
  const PixelSequence sequence(Sequence::Independent, 3, 17);
  std::vector<int> counts(256, 0), successive(256, 0);
  std::uint32_t previous = 0;
  for (std::uint32_t i = 0; i < (1u << 16); ++i) {
    const auto p = sequence.pair(i, 4);
    ++counts[(cell(p.x, 4) << 4) | cell(p.y, 4)];
    ++successive[(cell(previous, 4) << 4) | cell(p.x, 4)];
    previous = p.x;
  }
  EXPECT_LT(testing::chi_squared(counts, 256.0), testing::chi_squared_limit(255));
  EXPECT_LT(testing::chi_squared(successive, 256.0), testing::chi_squared_limit(255));
}

TEST(UnitNumbers, NeverReachOne) {
  EXPECT_EQ(unit_float(0xffffffffu), 1.0f - 0x1p-24f);
  EXPECT_EQ(unit_float(0u), 0.0f);
  EXPECT_EQ(unit_float(0x80000000u), 0.5f);
  EXPECT_LT(unit_double(0xffffffffu), 1.0);
  EXPECT_GT(unit_double(0u), 0.0);
  EXPECT_EQ(unit_double(0x80000000u) + unit_double(0x7fffffffu), 1.0);  // symmetric about one half
}

}  // namespace
}  // namespace sturm
