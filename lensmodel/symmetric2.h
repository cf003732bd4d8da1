#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// a·b − c·d without cancellation error beyond 1.5 ulp (Kahan's algorithm with a fused multiply-add).
double difference_of_products(double a, double b, double c, double d);

/// Eigenvalues of a symmetric 2×2 matrix [[xx, xy], [xy, yy]], ordered by size of the value itself.
struct PrincipalValues {
  double high, low;                ///< high ≥ low, unit of the matrix
  Eigen::Vector2d high_direction;  ///< unit vector; (1, 0) where both values are equal
  bool isotropic;                  ///< both values are equal: the directions mean nothing
};

/// Closed form; the smaller value in magnitude comes from the determinant, so it keeps its relative accuracy.
PrincipalValues principal_values(double xx, double xy, double yy);

/// Singular values of any 2×2 matrix and the left singular vector of the larger one.
struct SingularValues {
  double large, small;              ///< large ≥ small ≥ 0
  Eigen::Vector2d large_direction;  ///< left singular vector; (1, 0) where both are equal
  bool isotropic;
};

SingularValues singular_values(const Eigen::Matrix2d& m);

}  // namespace sturm
