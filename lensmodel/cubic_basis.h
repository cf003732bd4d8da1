#pragma once
#include <array>

namespace sturm {

/// The four uniform cubic B-splines that are not zero in a cell, with their first two derivatives by the knot number,
/// at 0 ≤ t ≤ 1 of it.
struct CubicBasis {
  std::array<double, 4> value, first, second;

  explicit CubicBasis(double t) {
    const double s = 1.0 - t;
    value = {s * s * s / 6.0, (4.0 + t * t * (3.0 * t - 6.0)) / 6.0, (4.0 + s * s * (3.0 * s - 6.0)) / 6.0,
             t * t * t / 6.0};
    first = {-0.5 * s * s, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), 0.5 * t * t};
    second = {s, 3.0 * t - 2.0, 3.0 * s - 2.0, t};
  }
};

}  // namespace sturm
