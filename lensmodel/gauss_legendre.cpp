#include "lensmodel/gauss_legendre.h"

#include <cmath>
#include <numbers>

namespace sturm {

std::vector<QuadratureNode> gauss_legendre(int n) {
  std::vector<QuadratureNode> nodes(static_cast<std::size_t>(n));
  for (int i = 0; i < (n + 1) / 2; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    // Newton's iteration converges quadratically from this start; six steps are two more than rounding needs.
    for (int step = 0; step < 6; ++step) {
      double before = 1.0, value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    const double weight = 2.0 / ((1.0 - x * x) * slope * slope);
    nodes[static_cast<std::size_t>(i)] = {-x, weight};
    nodes[static_cast<std::size_t>(n - 1 - i)] = {x, weight};
  }
  return nodes;
}

}  // namespace sturm
