#include "wavefront/fitting/least_squares.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace sturm {

namespace {

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner>;

}  // namespace

LeastSquares least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  // A = QR with a small square R, which has the singular values of A.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(matrix.cols()).triangularView<Eigen::Upper>();
  const Eigen::VectorXd turned = qr.householderQ().adjoint() * values;
  const Svd svd(r, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::MatrixXd scaled = svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal();
  return {svd.solve(turned.head(matrix.cols())), svd.singularValues(), scaled * scaled.transpose()};
}

LeastSquares small_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  const Svd svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.solve(values), svd.singularValues(), {}};
}

}  // namespace sturm
