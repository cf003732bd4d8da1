#include "wavefront/fitting/least_squares.h"

#include <Eigen/SVD>

namespace sturm {

LeastSquares least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::MatrixXd scaled = svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal();
  return {svd.solve(values), svd.singularValues(), scaled * scaled.transpose()};
}

LeastSquares small_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.solve(values), svd.singularValues(), {}};
}

}  // namespace sturm
