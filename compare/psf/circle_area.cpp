#include "compare/psf/circle_area.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

/// Area of the disc within 0 ≤ x ≤ a and 0 ≤ y ≤ b, for a, b ≥ 0.
double corner_area(double a, double b, double radius) {
  a = std::min(a, radius), b = std::min(b, radius);
  const double squared = radius * radius;
  if (a * a + b * b <= squared) return a * b;
  const double leaves = std::sqrt(std::max(0.0, squared - b * b));  // where the circle comes below the height b
  const auto below_circle = [&](double x) {                         // ∫ √(r² − x²) dx from 0
    return 0.5 * (x * std::sqrt(std::max(0.0, squared - x * x)) + squared * std::asin(std::min(1.0, x / radius)));
  };
  return leaves * b + below_circle(a) - below_circle(leaves);
}

double signed_corner_area(double x, double y, double radius) {
  const double area = corner_area(std::abs(x), std::abs(y), radius);
  return (x < 0.0) == (y < 0.0) ? area : -area;
}

}  // namespace

double area_within_circle(const Eigen::Vector2d& middle, double side, double radius) {
  const double half = 0.5 * side;
  const Eigen::Vector2d from_axes = middle.cwiseAbs();
  if ((from_axes.array() + half).matrix().norm() <= radius) return side * side;
  if ((from_axes.array() - half).max(0.0).matrix().norm() >= radius) return 0.0;
  const double x0 = middle.x() - half, x1 = middle.x() + half, y0 = middle.y() - half, y1 = middle.y() + half;
  return signed_corner_area(x1, y1, radius) - signed_corner_area(x0, y1, radius) - signed_corner_area(x1, y0, radius) +
         signed_corner_area(x0, y0, radius);
}

}  // namespace sturm
