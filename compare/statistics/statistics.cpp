#include "compare/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "compare/statistics/random_draws.h"
#include "compare/statistics/running_moments.h"

namespace sturm {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double tiny = std::numeric_limits<double>::min() / epsilon;
constexpr double largest_normal_deviate = 37.5;  // P(Z > 37.5) = 5e-308

/// Modified Lentz evaluation of b0 + a1/(b1 + a2/(b2 + …)); `term(i)` gives (a_i, b_i) for i ≥ 1.
template <class Term>
double continued_fraction(double b0, Term term) {
  double value = b0 != 0.0 ? b0 : tiny, c = value, d = 0.0;
  // The fractions used here converge in O(√max(a, b)) terms; the cap is a guard for absurd arguments.
  for (int i = 1; i < 100000; ++i) {
    const auto [a, b] = term(i);
    d = b + a * d;
    if (d == 0.0) d = tiny;
    c = b + a / c;
    if (c == 0.0) c = tiny;
    d = 1.0 / d;
    const double factor = c * d;
    value *= factor;
    if (std::abs(factor - 1.0) < 2.0 * epsilon) return value;
  }
  throw std::domain_error("continued fraction does not converge");
}

struct Term {
  double a, b;
};

/// log(x^a (1−x)^b / B(a, b)).
double log_beta_front(double a, double b, double x) {
  return std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x);
}

double beta_fraction(double a, double b, double x) {
  const double front = std::exp(log_beta_front(a, b, x)) / a;
  return front / continued_fraction(1.0, [=](int i) {
           const int m = i / 2;
           const double numerator = i % 2 == 0 ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                                               : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
           return Term{numerator, 1.0};
         });
}

}  // namespace

double normal_upper_tail(double z) {
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

double normal_two_sided(double z) {
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

double normal_upper_quantile(double upper_tail) {
  if (!(upper_tail > 0.0 && upper_tail < 1.0))
    throw std::domain_error("normal_upper_quantile: probability outside (0, 1)");
  if (upper_tail > 0.5) return -normal_upper_quantile(1.0 - upper_tail);
  // Bisection on the logarithm of the tail: 38 is beyond the smallest probability that a double can hold.
  double low = 0.0, high = 38.0;
  for (int i = 0; i < 200 && high - low > epsilon * high; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_upper_tail(middle) > upper_tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double regularised_incomplete_beta(double a, double b, double x) {
  if (!(a > 0.0 && b > 0.0 && x >= 0.0 && x <= 1.0))
    throw std::domain_error("regularised_incomplete_beta: argument out of range");
  if (x == 0.0 || x == 1.0) return x;
  // The fraction converges fast below the mean; above it the symmetric function is used.
  return x < (a + 1.0) / (a + b + 2.0) ? beta_fraction(a, b, x) : 1.0 - beta_fraction(b, a, 1.0 - x);
}

double regularised_upper_gamma(double a, double x) {
  if (!(a > 0.0 && x >= 0.0)) throw std::domain_error("regularised_upper_gamma: argument out of range");
  if (x == 0.0) return 1.0;
  const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x >= a + 1.0)
    return front / continued_fraction(x + 1.0 - a, [=](int i) { return Term{i * (a - i), x + 2 * i + 1.0 - a}; });
  double sum = 1.0 / a, term = sum;
  for (double n = a + 1.0; term > sum * epsilon; n += 1.0) sum += term *= x / n;
  return 1.0 - front * sum;
}

double student_t_two_sided(double t, double degrees) {
  if (!(degrees > 0.0)) throw std::domain_error("student_t_two_sided: degrees of freedom must be positive");
  if (std::isinf(t)) return 0.0;
  return regularised_incomplete_beta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

double student_t_two_sided_quantile(double two_sided, double degrees) {
  if (!(two_sided > 0.0 && two_sided < 1.0))
    throw std::domain_error("student_t_two_sided_quantile: probability outside (0, 1)");
  double low = 0.0, high = 1.0;
  while (student_t_two_sided(high, degrees) > two_sided) low = high, high *= 2.0;
  for (int i = 0; i < 200 && high - low > epsilon * high; ++i) {
    const double middle = 0.5 * (low + high);
    (student_t_two_sided(middle, degrees) > two_sided ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double normal_equivalent_of_t(double t, double degrees) {
  if (t == 0.0) return 0.0;
  const double tail = 0.5 * student_t_two_sided(t, degrees);
  const double z = tail > 1e-307 ? normal_upper_quantile(std::min(tail, 0.5)) : largest_normal_deviate;
  return std::copysign(z, t);
}

double fisher_upper_tail(double f, double d1, double d2) {
  if (f <= 0.0) return 1.0;
  return regularised_incomplete_beta(0.5 * d2, 0.5 * d1, d2 / (d2 + d1 * f));
}

double chi_squared_upper_tail(double x, double degrees) {
  return x <= 0.0 ? 1.0 : regularised_upper_gamma(0.5 * degrees, 0.5 * x);
}

double sidak_level(double family, std::size_t tests) {
  if (!(family > 0.0 && family < 1.0) || tests == 0)
    throw std::domain_error("sidak_level: needs 0 < family < 1 and at least one test");
  return -std::expm1(std::log1p(-family) / static_cast<double>(tests));
}

double bootstrap_standard_error(std::size_t items, const std::function<double(std::span<const std::size_t>)>& statistic,
                                int resamples, std::uint64_t seed) {
  if (items == 0 || resamples < 2)
    throw std::domain_error("bootstrap_standard_error: needs items and at least two resamples");
  std::vector<std::size_t> indices(items);
  RunningMoments moments;
  for (int r = 0; r < resamples; ++r) {
    // A modulo bias of items/2^64 is far below the bootstrap's own error.
    for (std::size_t& index : indices) index = static_cast<std::size_t>(next_random(seed) % items);
    moments.add(statistic(indices));
  }
  return moments.deviation();
}

}  // namespace sturm
