#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace sturm {

/// P(Z > z) of the standard normal distribution; accurate in relative terms far into the upper tail.
double normal_upper_tail(double z);

/// P(|Z| > |z|).
double normal_two_sided(double z);

/// z with P(Z > z) = `upper_tail`, for 0 < upper_tail < 1. Throws std::domain_error outside.
double normal_upper_quantile(double upper_tail);

/// Regularised incomplete beta function I_x(a, b), a, b > 0, 0 ≤ x ≤ 1: continued fraction by Lentz's method
/// (Abramowitz & Stegun 26.5.8).
double regularised_incomplete_beta(double a, double b, double x);

/// Upper regularised incomplete gamma function Q(a, x), a > 0, x ≥ 0: series below a + 1, continued fraction above
/// (Abramowitz & Stegun 6.5.29, 6.5.31).
double regularised_upper_gamma(double a, double x);

/// P(|T| > |t|) of Student's t with `degrees` > 0 degrees of freedom.
double student_t_two_sided(double t, double degrees);

/// t > 0 with P(|T| > t) = `two_sided`, 0 < two_sided < 1. Throws std::domain_error outside.
double student_t_two_sided_quantile(double two_sided, double degrees);

/// The normal deviate with the same tail probability and sign as `t`, so that statistics of different degrees of
/// freedom can be put together. Saturates at ±37.5, where the tail probability leaves the range of double.
double normal_equivalent_of_t(double t, double degrees);

/// P(X > f) of Fisher's F with (d1, d2) degrees of freedom.
double fisher_upper_tail(double f, double d1, double d2);

/// P(X > x) of chi squared with `degrees` > 0 degrees of freedom.
double chi_squared_upper_tail(double x, double degrees);

/// Level of each single test so that `tests` independent tests together have the false-alarm rate `family` (Šidák):
/// 1 − (1 − family)^(1/tests). Conservative for positively dependent tests.
double sidak_level(double family, std::size_t tests);

/// Standard deviation over `resamples` ≥ 2 bootstrap resamples of `statistic`, which gets `items` indices drawn with
/// replacement from 0 … items − 1. Deterministic: the generator depends on `seed` alone, not on the standard library.
double bootstrap_standard_error(std::size_t items, const std::function<double(std::span<const std::size_t>)>& statistic,
                                int resamples, std::uint64_t seed);

}  // namespace sturm
