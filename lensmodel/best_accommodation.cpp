#include "lensmodel/best_accommodation.h"

#include <cmath>
#include <complex>
#include <utility>

#include "lensmodel/bracketed_root.h"

namespace sturm {

namespace {

using Complex = std::complex<double>;

/// |m − A n| as a function of A.
struct Distance {
  Complex m, n;

  double nearest() const { return (m * std::conj(n)).real() / std::norm(n); }  ///< the A where it is least

  /// First and second derivative; at a kink, where the distance vanishes, the one-sided derivative.
  std::pair<double, double> derivatives(double a, double side) const {
    const double square = std::norm(n), numerator = square * a - (m * std::conj(n)).real(),
                 distance = std::abs(m - a * n);
    if (distance == 0.0) return {side * std::sqrt(square), 0.0};
    return {numerator / distance,
            (square * distance * distance - numerator * numerator) / (distance * distance * distance)};
  }
};

}  // namespace

double best_accommodation(const Eigen::Matrix2d& m, const Eigen::Matrix2d& n, double amplitude) {
  const auto keeps = [](const Eigen::Matrix2d& x) { return 0.5 * Complex(x(0, 0) + x(1, 1), x(1, 0) - x(0, 1)); };
  const auto mirrors = [](const Eigen::Matrix2d& x) { return 0.5 * Complex(x(0, 0) - x(1, 1), x(1, 0) + x(0, 1)); };
  const Distance terms[] = {{keeps(m), keeps(n)}, {mirrors(m), mirrors(n)}};
  const auto slope = [&](double a, double side) {
    const auto first = terms[0].derivatives(a, side), second = terms[1].derivatives(a, side);
    return std::pair(first.first + second.first, first.second + second.second);
  };
  double low = 0.0, high = amplitude;
  if (slope(low, 1.0).first >= 0.0) return low;
  if (slope(high, -1.0).first <= 0.0) return high;
  constexpr double near = 1e-9;  // [D]: around a kink or what is nearly one, where Newton's iteration would not help
  for (const Distance& term : terms) {
    if (term.n == 0.0) continue;
    const double below = term.nearest() - near, above = term.nearest() + near;
    if (below > low && below < high && slope(below, 1.0).first < 0.0) low = below;
    if (above > low && above < high && slope(above, -1.0).first > 0.0) high = above;
  }
  return bracketed_root([&](double a) { return slope(a, 1.0); }, low, high).value_or(0.5 * (low + high));
}

}  // namespace sturm
