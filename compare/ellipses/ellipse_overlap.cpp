#include "compare/ellipses/ellipse_overlap.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "lensmodel/symmetric2.h"

namespace sturm {

namespace {

using Complex = std::complex<double>;
constexpr double full_turn = 2.0 * std::numbers::pi;

double turn_of(double angle) {
  const double folded = std::fmod(angle, full_turn);
  return folded < 0.0 ? folded + full_turn : folded;
}

/// Roots of c[4] z⁴ + … + c[0] of any actual degree, all at once by the method of Weierstrass, Durand and Kerner:
/// quadratic convergence to single roots, and halving of the error of double ones in each round.
std::vector<Complex> roots_of(std::vector<Complex> c) {
  double scale = 0.0;
  for (const Complex& x : c) scale = std::max(scale, std::abs(x));
  while (c.size() > 1 && std::abs(c.back()) <= 1e-15 * scale) c.pop_back();
  const std::size_t degree = c.size() - 1;
  std::vector<Complex> roots;
  for (std::size_t i = 0; i < degree; ++i)
    roots.push_back(std::polar(1.0, 0.4 + full_turn * static_cast<double>(i) / static_cast<double>(degree)));
  constexpr int most_rounds = 200;
  double change = 1.0;
  for (int round = 0; round < most_rounds && change > 1e-15; ++round) {
    change = 0.0;
    for (std::size_t i = 0; i < degree; ++i) {
      Complex value = c[degree], others = c[degree];
      for (std::size_t k = degree; k-- > 0;) value = value * roots[i] + c[k];
      for (std::size_t k = 0; k < degree; ++k)
        if (k != i) others *= roots[i] - roots[k];
      if (others == 0.0) continue;
      roots[i] -= value / others;
      change = std::max(change, std::abs(value / others));
    }
  }
  return roots;
}

/// The ellipse c + M u, |u| = 1, seen where the other one is the unit circle.
struct Seen {
  Eigen::Vector2d c;
  Eigen::Matrix2d m, inverse;

  Eigen::Vector2d at(double s) const { return c + m * Eigen::Vector2d(std::cos(s), std::sin(s)); }
  bool contains(const Eigen::Vector2d& x) const { return (inverse * (x - c)).squaredNorm() <= 1.0; }
};

/// Angles t of the unit circle where it meets the ellipse: |M⁻¹(x − c)|² = 1 is a trigonometric polynomial of degree 2
/// in t; with z = e^{it} a quartic.
std::vector<double> crossings(const Seen& ellipse) {
  const Eigen::Matrix2d q = ellipse.inverse.transpose() * ellipse.inverse;
  const Eigen::Vector2d linear = -2.0 * q * ellipse.c;
  const double constant = ellipse.c.dot(q * ellipse.c) - 1.0 + 0.5 * q.trace();
  const Complex second(0.25 * (q(0, 0) - q(1, 1)), -0.5 * q(0, 1)), first(0.5 * linear.x(), -0.5 * linear.y());
  std::vector<double> angles;
  for (const Complex& z : roots_of({std::conj(second), std::conj(first), constant, first, second}))
    if (std::abs(std::abs(z) - 1.0) < 1e-6)
      angles.push_back(turn_of(std::arg(z)));  // a root too many only splits an arc
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Sum of `piece(from, to)` over the arcs between sorted `cuts` whose middle is inside.
template <class Inside, class Piece>
double sum_of_arcs(const std::vector<double>& cuts, const Inside& inside, const Piece& piece) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const double from = cuts[i], to = i + 1 < cuts.size() ? cuts[i + 1] : cuts.front() + full_turn;
    if (inside(0.5 * (from + to))) sum += piece(from, to);
  }
  return sum;
}

double common_area_with_unit_circle(const Seen& ellipse) {
  const std::vector<double> on_circle = crossings(ellipse);
  const double determinant = ellipse.m.determinant(), area = std::numbers::pi * std::abs(determinant);
  if (on_circle.size() < 2) {  // one inside the other, or apart
    if (ellipse.at(0.0).squaredNorm() <= 1.0 && ellipse.at(std::numbers::pi).squaredNorm() <= 1.0) return area;
    return ellipse.contains({1.0, 0.0}) && ellipse.contains({-1.0, 0.0}) ? std::numbers::pi : 0.0;
  }
  std::vector<double> on_ellipse;
  for (const double t : on_circle) {
    const Eigen::Vector2d u = ellipse.inverse * (Eigen::Vector2d(std::cos(t), std::sin(t)) - ellipse.c);
    on_ellipse.push_back(turn_of(std::atan2(u.y(), u.x())));
  }
  std::sort(on_ellipse.begin(), on_ellipse.end());
  // ½∮(x dy − y dx), counter-clockwise; a map that mirrors runs the other way.
  const double of_circle = sum_of_arcs(
      on_circle,
      [&](double t) {
        return ellipse.contains({std::cos(t), std::sin(t)});
      },
      [](double from, double to) { return 0.5 * (to - from); });
  const double of_ellipse = sum_of_arcs(
      on_ellipse, [&](double s) { return ellipse.at(s).squaredNorm() <= 1.0; },
      [&](double from, double to) {
        const Eigen::Vector2d step = ellipse.at(to) - ellipse.at(from);
        return 0.5 * (determinant * (to - from) + ellipse.c.x() * step.y() - ellipse.c.y() * step.x());
      });
  return of_circle + std::copysign(1.0, determinant) * of_ellipse;
}

}  // namespace

FilledEllipse FilledEllipse::of_second_moments(const Eigen::Matrix2d& covariance, const Eigen::Vector2d& centre) {
  const PrincipalValues p = principal_values(covariance(0, 0), covariance(0, 1), covariance(1, 1));
  const Eigen::Vector2d u = p.high_direction, v(-u.y(), u.x());
  FilledEllipse e{centre, {}};
  e.map << 2.0 * std::sqrt(std::max(0.0, p.high)) * u, 2.0 * std::sqrt(std::max(0.0, p.low)) * v;
  return e;
}

double FilledEllipse::area() const {
  return std::numbers::pi * std::abs(map.determinant());
}

double common_area(const FilledEllipse& a, const FilledEllipse& b) {
  if (a.area() == 0.0 || b.area() == 0.0) return 0.0;
  const Eigen::Matrix2d to_circle = a.map.inverse();
  Seen seen{to_circle * (b.centre - a.centre), to_circle * b.map, {}};
  seen.inverse = seen.m.inverse();
  return std::clamp(common_area_with_unit_circle(seen) * a.area() / std::numbers::pi, 0.0,
                    std::min(a.area(), b.area()));
}

std::optional<double> intersection_over_union(const FilledEllipse& a, const FilledEllipse& b) {
  const double common = common_area(a, b), either = a.area() + b.area() - common;
  return either > 0.0 ? std::optional(common / either) : std::nullopt;
}

}  // namespace sturm
