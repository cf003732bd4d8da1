#pragma once
#include <Eigen/Core>

namespace sturm {

/// The A in [0, amplitude] that makes the larger singular value of X(A) = m − A·n least; the smallest one if there are
/// several.
///
/// As a map of the complex plane X z = α z + β z̄, and its larger singular value is |α| + |β| with α and β affine in A:
/// the sum of the distances of a point that moves on a line from two fixed points (weighted). That is convex; its slope
/// is solved for by Newton's iteration in a bracket, to 16 units in the last place of the amplitude. Where the line
/// runs through one of the points (a spherical power) the sum has a kink, which is looked for first.
double best_accommodation(const Eigen::Matrix2d& m, const Eigen::Matrix2d& n, double amplitude);

}  // namespace sturm
