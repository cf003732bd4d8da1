#pragma once
#include <cmath>
#include <numbers>

namespace sturm {

/// sin(πx)/(πx): what averaging over an interval of length 1 leaves of a wave of x cycles in it.
inline double sinc(double x) {
  return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

}  // namespace sturm
