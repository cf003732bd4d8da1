#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "compare/statistics/random_draws.h"
#include "compare/statistics/sample_size.h"
#include "compare/statistics/test_family.h"
#include "support/two_sample_tests.h"

namespace sturm {
namespace {

std::vector<double> normal_sample(std::uint64_t seed, int size, double mean, double deviation) {
  NormalDraws draws(seed);
  std::vector<double> values;
  for (int i = 0; i < size; ++i) values.push_back(mean + deviation * draws.next());
  return values;
}

TEST(Welch, ByHand) {
  // Means 3 and 6, variances of the means 2.5/5 and 10/5: t = −3/√2.5, degrees (2.5)²/(0.25/4 + 4/4).
  const std::vector<double> a{1, 2, 3, 4, 5}, b{2, 4, 6, 8, 10};
  const TwoSampleTest t = welch_test(a, b);
  EXPECT_NEAR(t.statistic, -1.8973665961010275, 1e-12);
  EXPECT_NEAR(t.degrees, 5.882352941176471, 1e-12);
  EXPECT_NEAR(t.p, 0.107531193, 1e-8);  // R: t.test(1:5, 2*(1:5))
  EXPECT_LT(t.z, 0.0);
  EXPECT_EQ(welch_test(b, a).z, -t.z);
  const std::vector<double> one{1, 1}, two{2, 2};
  EXPECT_EQ(welch_test(one, one).p, 1.0);
  EXPECT_EQ(welch_test(two, one).p, 0.0);
  EXPECT_GT(welch_test(two, one).z, 30.0);
  EXPECT_THROW(welch_test(std::vector<double>{1}, one), std::invalid_argument);
}

TEST(KolmogorovSmirnov, TailOfTheTables) {
  EXPECT_NEAR(kolmogorov_upper_tail(1.3581), 0.05, 2e-5);  // printed quantiles have five digits
  EXPECT_NEAR(kolmogorov_upper_tail(1.6276), 0.01, 1e-5);
  EXPECT_NEAR(kolmogorov_upper_tail(0.8276), 0.5, 5e-5);
  EXPECT_NEAR(kolmogorov_upper_tail(1.0 - 1e-12), kolmogorov_upper_tail(1.0), 1e-10);  // the two series meet
  EXPECT_EQ(kolmogorov_upper_tail(0.0), 1.0);
}

TEST(KolmogorovSmirnov, ByHandAndWithTies) {
  EXPECT_NEAR(kolmogorov_smirnov_test({1, 2, 3, 4}, {3.5, 4.5, 5.5}).statistic, 0.75, 1e-15);
  EXPECT_NEAR(kolmogorov_smirnov_test({1, 1, 2, 2}, {1, 2}).statistic, 0.0, 1e-15);
  EXPECT_NEAR(kolmogorov_smirnov_test({1, 2}, {5, 6, 7}).statistic, 1.0, 1e-15);
}

TEST(TwoSampleTests, HoldTheirLevel) {
  int welch = 0, ks = 0;
  constexpr int trials = 1000;
  for (int i = 0; i < trials; ++i) {
    const std::vector<double> a = normal_sample(2 * i, 12, 0.0, 1.0), b = normal_sample(2 * i + 1, 30, 0.0, 1.0);
    welch += welch_test(a, b).p < 0.05;
    ks += kolmogorov_smirnov_test(a, b).p < 0.05;
  }
  EXPECT_NEAR(welch, 50, 28);  // 4σ of a binomial of 1000 × 0.05
  EXPECT_NEAR(ks, 50, 28);
}

TEST(TwoSampleTests, SeeWhatTheyAreFor) {
  // Equal means and unequal spread: for Kolmogorov and Smirnov, not for Welch.
  const std::vector<double> a = normal_sample(1, 400, 0.0, 1.0), b = normal_sample(2, 400, 0.0, 2.0),
                            c = normal_sample(3, 400, 0.5, 1.0);
  EXPECT_GT(welch_test(a, b).p, 0.001);
  EXPECT_LT(kolmogorov_smirnov_test(a, b).p, 1e-4);
  EXPECT_LT(welch_test(a, c).z, -4.0);
  EXPECT_GT(kolmogorov_smirnov_test(a, c).z, 4.0);
}

TEST(TestFamily, LevelFollowsTheNumberOfTests) {
  TestFamily family(0.05);
  EXPECT_NEAR(family.two_sided_threshold(), 1.959963984540054, 1e-9);
  for (int i = 0; i < 10; ++i) family.add("test " + std::to_string(i), i == 3 ? -3.2 : i == 7 ? 2.5 : 0.3);
  EXPECT_EQ(family.tests(), 10u);
  EXPECT_NEAR(family.single_level(), 1.0 - std::pow(0.95, 0.1), 1e-15);
  EXPECT_EQ(family.significant(), std::vector<std::string>{"test 3"});
  EXPECT_LT(family.one_sided_threshold(), family.two_sided_threshold());
  EXPECT_THROW(TestFamily(0.0), std::domain_error);
}

TEST(SampleSize, OfAPerMilleAtFourSigma) {
  // ½·√((2 − 1)/N) = 0.001/4
  EXPECT_EQ(rays_for_semi_axis({}, 2.0), 4'000'000u);
  EXPECT_EQ(rays_for_semi_axis({.both_measured = true}, 2.0), 8'000'000u);
  EXPECT_EQ(rays_for_semi_axis({}, 3.0), 8'000'000u);
  EXPECT_EQ(samples_for_mean({.relative_difference = 0.01, .sigmas = 3.0}, 2.0), 360'000u);
  // z of 90 % power: 1.2815515655446004; (4 + z)²/4 · 1e6
  EXPECT_NEAR(static_cast<double>(rays_for_semi_axis({.power = 0.9}, 2.0)),
              0.25e6 * 5.2815515655446004 * 5.2815515655446004, 2.0);
  EXPECT_THROW(rays_for_semi_axis({}, 1.0), std::domain_error);
  EXPECT_THROW(rays_for_semi_axis({.relative_difference = 0.0}, 2.0), std::domain_error);
  EXPECT_THROW(rays_for_semi_axis({.power = 1.0}, 2.0), std::domain_error);
}

}  // namespace
}  // namespace sturm
