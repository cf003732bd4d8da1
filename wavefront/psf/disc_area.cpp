#include "wavefront/psf/disc_area.h"

#include <algorithm>
#include <cmath>

namespace sturm {

double area_within_disc(double x0, double x1, double y0, double y1, double radius) {
  const double square = radius * radius;
  if (x1 * x1 + y1 * y1 <= square) return (x1 - x0) * (y1 - y0);
  if (x0 * x0 + y0 * y0 >= square) return 0.0;
  // Below `full` the rim lies above the rectangle, from `full` to `end` it crosses it.
  const double full = y1 < radius ? std::sqrt(square - y1 * y1) : 0.0;
  const double end = std::min(x1, std::sqrt(square - y0 * y0));
  const double start = std::clamp(full, x0, end);
  const auto under_rim = [&](double x) {
    return 0.5 * (x * std::sqrt(std::max(0.0, square - x * x)) + square * std::asin(std::min(1.0, x / radius)));
  };
  const double whole = (start - x0) * (y1 - y0);
  return whole + under_rim(end) - under_rim(start) - y0 * (end - start);
}

}  // namespace sturm
