#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/statistics/statistics.h"

namespace sturm {
namespace {

constexpr double relative_rounding = 1e-12;  // lgamma and a few hundred operations

void expect_relative(double value, double expected, double tolerance = relative_rounding) {
  EXPECT_NEAR(value / expected, 1.0, tolerance) << value << " instead of " << expected;
}

TEST(Statistics, NormalTailsKeepTheirDigitsFarOut) {
  expect_relative(normal_upper_tail(1.959963984540054), 0.025);    // tables
  expect_relative(normal_upper_tail(6.0), 9.865876450376946e-10);  // tables
  EXPECT_DOUBLE_EQ(normal_two_sided(-3.0), 2.0 * normal_upper_tail(3.0));
  for (const double p : {1e-300, 1e-9, 0.001, 0.3, 0.5, 0.9})
    expect_relative(normal_upper_tail(normal_upper_quantile(p)), p, 1e-11);  // p·z²·ε
  EXPECT_GT(normal_upper_quantile(0.1), 0.0);
  EXPECT_LT(normal_upper_quantile(0.9), 0.0);
  EXPECT_THROW(normal_upper_quantile(0.0), std::domain_error);
}

TEST(Statistics, IncompleteBetaHasItsClosedForms) {
  for (const double x : {0.0, 0.01, 0.3, 0.77, 0.999, 1.0})
    for (const double b : {0.5, 1.0, 7.5, 40.0}) {
      EXPECT_NEAR(regularised_incomplete_beta(1.0, b, x), 1.0 - std::pow(1.0 - x, b), 1e-13);
      EXPECT_NEAR(regularised_incomplete_beta(b, 1.0, x), std::pow(x, b), 1e-13);
    }
  EXPECT_THROW(regularised_incomplete_beta(1.0, 1.0, 1.5), std::domain_error);
}

TEST(Statistics, StudentsTailsHaveTheirClosedForms) {
  for (const double t : {0.01, 0.5, 2.0, 30.0, 1e4}) {
    expect_relative(student_t_two_sided(t, 1.0), 2.0 * std::atan2(1.0, t) / std::numbers::pi);
    expect_relative(student_t_two_sided(t, 2.0), 2.0 / (std::sqrt(2.0 + t * t) * (std::sqrt(2.0 + t * t) + t)));
  }
  expect_relative(student_t_two_sided(2.131449545559323, 15.0), 0.05, 1e-10);  // tables
  EXPECT_NEAR(student_t_two_sided(4.0, 15.0), 1.2e-3, 0.05e-3);  // what a 4σ bound means with 16 replicates
  EXPECT_EQ(student_t_two_sided(-4.0, 15.0), student_t_two_sided(4.0, 15.0));
  // Abramowitz & Stegun 26.7.7: to first order in 1/ν the tail exceeds the normal one by φ(t)(t³ + t)/(4ν)
  const double t = 2.5, density = std::exp(-0.5 * t * t) / std::sqrt(2.0 * std::numbers::pi), degrees = 1e6;
  expect_relative(student_t_two_sided(t, degrees),
                  normal_two_sided(t) + 2.0 * density * (t * t * t + t) / (4.0 * degrees), 1e-9);
  for (const double p : {1e-12, 0.001, 0.5})
    expect_relative(student_t_two_sided(student_t_two_sided_quantile(p, 7.0), 7.0), p, 1e-11);
}

TEST(Statistics, NormalEquivalentKeepsSignAndTail) {
  EXPECT_EQ(normal_equivalent_of_t(0.0, 3.0), 0.0);
  expect_relative(normal_equivalent_of_t(2.131449545559323, 15.0), 1.959963984540054, 1e-10);
  EXPECT_EQ(normal_equivalent_of_t(-5.0, 3.0), -normal_equivalent_of_t(5.0, 3.0));
  EXPECT_EQ(normal_equivalent_of_t(INFINITY, 3.0), 37.5);
  EXPECT_EQ(normal_equivalent_of_t(-1e300, 3.0), -37.5);
}

TEST(Statistics, ChiSquaredAndFisherTails) {
  for (const double x : {1e-3, 0.7, 3.0, 50.0}) {
    expect_relative(chi_squared_upper_tail(x, 2.0), std::exp(-0.5 * x));
    expect_relative(chi_squared_upper_tail(x, 1.0), std::erfc(std::sqrt(0.5 * x)));
    expect_relative(chi_squared_upper_tail(x, 6.0), std::exp(-0.5 * x) * (1.0 + 0.5 * x + x * x / 8.0));
  }
  expect_relative(chi_squared_upper_tail(18.307038053275146, 10.0), 0.05);  // tables
  expect_relative(fisher_upper_tail(3.4105336446278497, 3.0, 13.0), 0.05, 1e-8);
  expect_relative(fisher_upper_tail(9.0, 1.0, 15.0), student_t_two_sided(3.0, 15.0));
}

TEST(Statistics, SidakLevelIsExactForIndependentTests) {
  EXPECT_DOUBLE_EQ(sidak_level(0.01, 1), 0.01);
  expect_relative(1.0 - std::pow(1.0 - sidak_level(0.05, 768), 768), 0.05);
  expect_relative(sidak_level(1e-15, 1000), 1e-18);  // no cancellation
  EXPECT_THROW(sidak_level(0.05, 0), std::domain_error);
}

TEST(Statistics, BootstrapErrorOfAMeanIsItsStandardError) {
  constexpr std::size_t n = 400;
  const auto mean = [](std::span<const std::size_t> indices) {
    double sum = 0.0;
    for (const std::size_t i : indices) sum += static_cast<double>(i);
    return sum / static_cast<double>(indices.size());
  };
  const double expected = std::sqrt((n * n - 1.0) / 12.0 / n);  // variance of 0 … n−1 over n
  // relative error of a standard deviation from 4000 resamples: 1/√8000 = 1.1 %; 4σ
  expect_relative(bootstrap_standard_error(n, mean, 4000, 7), expected, 0.045);
  EXPECT_EQ(bootstrap_standard_error(n, mean, 50, 7), bootstrap_standard_error(n, mean, 50, 7));
  EXPECT_NE(bootstrap_standard_error(n, mean, 50, 7), bootstrap_standard_error(n, mean, 50, 8));
}

}  // namespace
}  // namespace sturm
