#include "support/two_sample_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "compare/statistics/statistics.h"

namespace sturm {

namespace {

constexpr double largest_z = 37.5;

struct Sample {
  double size, mean, variance_of_mean;
};

Sample sample_of(std::span<const double> values) {
  if (values.size() < 2) throw std::invalid_argument("welch_test: a sample of fewer than two values");
  const double n = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (const double v : values) mean += v / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {n, mean, squares / (n - 1.0) / n};
}

double z_of_two_sided(double p) {
  return p >= 1.0 ? 0.0 : 0.5 * p > 1e-307 ? normal_upper_quantile(0.5 * p) : largest_z;
}

}  // namespace

TwoSampleTest welch_test(std::span<const double> a, std::span<const double> b) {
  const Sample x = sample_of(a), y = sample_of(b);
  const double variance = x.variance_of_mean + y.variance_of_mean, difference = x.mean - y.mean;
  TwoSampleTest test;
  if (variance == 0.0) {
    if (difference == 0.0) return test;
    return {std::copysign(std::numeric_limits<double>::max(), difference), 0.0, 0.0,
            std::copysign(largest_z, difference)};
  }
  test.statistic = difference / std::sqrt(variance);
  test.degrees = variance * variance /
                 (x.variance_of_mean * x.variance_of_mean / (x.size - 1.0) +
                  y.variance_of_mean * y.variance_of_mean / (y.size - 1.0));
  test.p = student_t_two_sided(test.statistic, test.degrees);
  test.z = normal_equivalent_of_t(test.statistic, test.degrees);
  return test;
}

double kolmogorov_upper_tail(double x) {
  if (x <= 0.0) return 1.0;
  constexpr double pi = std::numbers::pi;
  if (x < 1.0) {  // the same function as a theta series that converges where the other does not
    double sum = 0.0;
    for (int k = 1; k <= 7; k += 2) sum += std::exp(-k * k * pi * pi / (8.0 * x * x));
    return 1.0 - std::sqrt(2.0 * pi) / x * sum;
  }
  double sum = 0.0;
  for (int k = 1; k <= 8; ++k) sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
  return sum;
}

TwoSampleTest kolmogorov_smirnov_test(std::vector<double> a, std::vector<double> b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("kolmogorov_smirnov_test: an empty sample");
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  const double n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  std::size_t i = 0, j = 0;
  TwoSampleTest test;
  while (i < a.size() && j < b.size()) {
    const double here = std::min(a[i], b[j]);
    while (i < a.size() && a[i] == here) ++i;
    while (j < b.size() && b[j] == here) ++j;
    test.statistic = std::max(test.statistic, std::abs(static_cast<double>(i) / n - static_cast<double>(j) / m));
  }
  const double root = std::sqrt(n * m / (n + m));
  test.p = kolmogorov_upper_tail((root + 0.12 + 0.11 / root) * test.statistic);
  test.z = z_of_two_sided(test.p);
  return test;
}

}  // namespace sturm
