#pragma once
#include <Eigen/Dense>
#include <numbers>
#include <vector>

namespace sturm::testing {

struct Node {
  double x, weight;
};

/// Gauss–Legendre nodes on [0, 1] as eigenvalues of the Jacobi matrix (Golub & Welsch 1969).
inline std::vector<Node> gauss_legendre_unit(int n) {
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
  for (int k = 1; k < n; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
  std::vector<Node> nodes;
  for (int k = 0; k < n; ++k)
    nodes.push_back({0.5 * (1.0 + solver.eigenvalues()[k]), std::pow(solver.eigenvectors()(0, k), 2)});
  return nodes;
}

/// Covariance of f(p) about its mean for p uniform over the disc of radius `radius`; exact for polynomials of degree <
/// 2·radial in r² and trigonometric degree < azimuthal.
template <class Function>
Eigen::Matrix2d covariance_over_disc(double radius, int radial, int azimuthal, Function&& f) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (const Node& node : gauss_legendre_unit(radial)) {
    for (int k = 0; k < azimuthal; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / azimuthal, weight = node.weight / azimuthal;
      const Eigen::Vector2d value =
          f(Eigen::Vector2d(radius * std::sqrt(node.x) * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
      mean += weight * value;
      second += weight * value * value.transpose();
    }
  }
  return second - mean * mean.transpose();
}

}  // namespace sturm::testing
