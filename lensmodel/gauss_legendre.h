#pragma once
#include <vector>

namespace sturm {

/// A node of a quadrature and its weight.
struct QuadratureNode {
  double x, weight;
};

/// Gauss–Legendre quadrature of n ≥ 1 nodes on [−1, 1]; the weights sum to 2. Exact for polynomials of degree < 2n.
std::vector<QuadratureNode> gauss_legendre(int n);

}  // namespace sturm
