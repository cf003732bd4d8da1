#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

/// Point sets with known moments for the tests of this folder.
namespace sturm::testing {

/// Ring quadrature of the disc of radius 1: its second moments (1/4) and fourth moments (E[x⁴] = 1/8, E[x²y²] = 1/24)
/// are those of the uniform disc to rounding. Radii from the two-point Gauss–Legendre rule in r², eight equal angles.
inline std::vector<Eigen::Vector2d> exact_disc() {
  std::vector<Eigen::Vector2d> points;
  for (const double t : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
    for (int k = 0; k < 8; ++k) {
      const double angle = (k + 0.3) * std::numbers::pi / 4.0;
      points.emplace_back(std::sqrt(t) * std::cos(angle), std::sqrt(t) * std::sin(angle));
    }
  return points;
}

/// Independent points, uniform over the disc of radius 1; the generator's bits are the same everywhere (its
/// distributions are not used).
inline std::vector<Eigen::Vector2d> random_disc(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double r = std::sqrt(uniform()), angle = 2.0 * std::numbers::pi * uniform();
    points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return points;
}

inline std::vector<Eigen::Vector2d> mapped(const Eigen::Matrix2d& map, std::vector<Eigen::Vector2d> points) {
  for (Eigen::Vector2d& p : points) p = map * p;
  return points;
}

}  // namespace sturm::testing
