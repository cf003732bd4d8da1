#pragma once
#include <cmath>
#include <vector>

namespace sturm::testing {

/// Mean of independent replicates and its standard error.
struct Estimate {
  double mean = 0.0, standard_error = 0.0;

  static Estimate of(const std::vector<double>& replicates) {
    const double n = static_cast<double>(replicates.size());
    Estimate e;
    for (double x : replicates) e.mean += x / n;
    double squares = 0.0;
    for (double x : replicates) squares += (x - e.mean) * (x - e.mean);
    e.standard_error = std::sqrt(squares / (n - 1.0) / n);
    return e;
  }
};

/// χ² of counts against one expected count for all bins.
inline double chi_squared(const std::vector<int>& counts, double expected) {
  double sum = 0.0;
  for (int n : counts) sum += (n - expected) * (n - expected) / expected;
  return sum;
}

/// Five standard deviations above the mean of χ² with `degrees` degrees of freedom.
inline double chi_squared_limit(int degrees) {
  return degrees + 5.0 * std::sqrt(2.0 * degrees);
}

}  // namespace sturm::testing
