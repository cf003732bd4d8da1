#pragma once
#include <Eigen/Core>

namespace sturm {

/// The vector x with the least |A x − b|, by singular values. In a file of its own, since Eigen's decompositions take a
/// compiler longer than all that asks for them.
struct LeastSquares {
  Eigen::VectorXd solution;
  Eigen::VectorXd singular_values;
  Eigen::MatrixXd unit_covariance;  ///< (AᵀA)⁻¹: the solution's covariance if b has unit variance
};

/// `matrix` has at least as many rows as columns. Where a singular value is 0, the covariance is not finite.
LeastSquares least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

/// The same where there are as many rows as columns, without a covariance.
LeastSquares small_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

}  // namespace sturm
