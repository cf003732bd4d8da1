#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace sturm {

/// The root of an increasing crossing f(low) ≤ 0 ≤ f(high) by Newton's iteration, with a bisection wherever Newton
/// would leave the bracket or gain less than a factor 2. `f(t)` gives (value, derivative). None if it has not settled
/// to 16 units in the last place of the bracket's larger end within `max_steps`, or where f is not a number; for a
/// function that is one, 60 bisections are always enough.
template <class Function>
std::optional<double> bracketed_root(Function&& f, double low, double high, int max_steps = 200) {
  const double resolution = 16.0 * std::numeric_limits<double>::epsilon() * std::fmax(std::abs(low), std::abs(high));
  double t = 0.5 * (low + high), previous_step = high - low;
  for (int i = 0; i < max_steps; ++i) {
    const auto [value, derivative] = f(t);
    if (std::isnan(value)) return std::nullopt;
    if (value == 0.0) return t;
    (value < 0.0 ? low : high) = t;
    double step = -value / derivative;
    if (!(t + step > low && t + step < high && 2.0 * std::abs(step) < std::abs(previous_step)))
      step = 0.5 * (low + high) - t;
    previous_step = step;
    t += step;
    if (std::abs(step) <= resolution) return t;
  }
  return std::nullopt;
}

}  // namespace sturm
