#pragma once
#include <Eigen/Core>

namespace sturm {

/// Area that a disc of `radius` ≥ 0 about the origin and a square of `side` > 0 about `middle`, its sides along the
/// axes, have in common: exact, from the areas between the circle and quadrants.
double area_within_circle(const Eigen::Vector2d& middle, double side, double radius);

}  // namespace sturm
