#pragma once
#include <cmath>

namespace sturm::testing {

/// Regularised incomplete beta function I_x(a, b) by its continued fraction (Lentz's method; Abramowitz &
/// Stegun 26.5.8).
inline double incomplete_beta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  if (x > (a + 1.0) / (a + b + 2.0)) return 1.0 - incomplete_beta(b, a, 1.0 - x);
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x)) / a;
  double c = 1.0, d = 1.0 / (1.0 - (a + b) * x / (a + 1.0)), fraction = d;
  for (int m = 1; m < 500; ++m) {
    const auto step = [&](double coefficient) {
      d = 1.0 / (1.0 + coefficient * d);
      c = 1.0 + coefficient / c;
      fraction *= c * d;
      return c * d;
    };
    step(m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m)));
    if (std::abs(step(-(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))) - 1.0) < 1e-14) break;
  }
  return front * fraction;
}

/// Probability that Student's t with `degrees` degrees of freedom lies further from 0 than t.
inline double student_two_sided(double t, double degrees) {
  return incomplete_beta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

}  // namespace sturm::testing
