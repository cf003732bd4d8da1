#pragma once
#include <cmath>
#include <span>

namespace sturm {

/// Standard error of a statistic of n ≥ 2 independent replicates by the jackknife (Efron & Stein 1981): `left_out`
/// holds the statistic with each replicate left out in turn. A shift that leaving out makes to all of them alike does
/// not count.
inline double jackknife_standard_error(std::span<const double> left_out) {
  const double n = static_cast<double>(left_out.size());
  double mean = 0.0, squares = 0.0;
  for (const double v : left_out) mean += v / n;
  for (const double v : left_out) squares += (v - mean) * (v - mean);
  return std::sqrt(squares * (n - 1.0) / n);
}

}  // namespace sturm
