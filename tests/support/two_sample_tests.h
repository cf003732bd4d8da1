#pragma once
#include <span>
#include <vector>

namespace sturm {

/// Result of a test of two samples.
struct TwoSampleTest {
  double statistic = 0.0;
  double degrees = 0.0;  ///< of freedom; 0 where the statistic has none
  double p = 1.0;        ///< two-sided
  double z = 0.0;        ///< normal deviate of the same p, with the sign of the statistic; saturates at ±37.5
};

/// Welch's t test of two means with unequal variances [Welch1947], Satterthwaite's degrees of freedom; positive where
/// `a` has the larger mean. Two samples without any scatter: p is 1 for equal means, 0 otherwise. Throws
/// std::invalid_argument for fewer than two values on a side.
TwoSampleTest welch_test(std::span<const double> a, std::span<const double> b);

/// Kolmogorov's and Smirnov's test of two distributions: the largest difference D between the empirical distribution
/// functions; p from the limit distribution with Stephens' correction (√N + 0.12 + 0.11/√N)·D, N = n m/(n + m)
/// [Stephens1970], good to some per cent of p from N = 4 on; conservative for values that occur several times. Throws
/// std::invalid_argument for an empty side.
TwoSampleTest kolmogorov_smirnov_test(std::vector<double> a, std::vector<double> b);

/// P(K > x) of Kolmogorov's distribution, 2 Σ (−1)^(k−1) exp(−2 k² x²).
double kolmogorov_upper_tail(double x);

}  // namespace sturm
