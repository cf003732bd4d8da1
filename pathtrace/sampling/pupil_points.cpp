#include "pathtrace/sampling/pupil_points.h"

#include <cmath>
#include <numbers>

#include "pathtrace/sampling/disk.h"
#include "pathtrace/sampling/sequence.h"

namespace sturm {

namespace {

struct Node {
  double x, weight;
};

/// Gauss–Legendre nodes on [0, 1] by Newton's iteration on the Legendre polynomial.
std::vector<Node> gauss_legendre(int n) {
  std::vector<Node> nodes(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), derivative = 1.0;
    for (int step = 0; step < 100; ++step) {
      double value = 1.0, previous = 0.0;
      for (int k = 1; k <= n; ++k) {
        const double older = previous;
        previous = value;
        value = ((2.0 * k - 1.0) * x * previous - (k - 1.0) * older) / k;
      }
      derivative = n * (x * value - previous) / (x * x - 1.0);
      const double change = value / derivative;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    nodes[static_cast<std::size_t>(i)] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * derivative * derivative)};
  }
  return nodes;
}

}  // namespace

void fill_unit_disk(Sequence sequence, std::uint64_t seed, std::uint32_t replicate, std::uint32_t first,
                    std::vector<Eigen::Vector2d>& points) {
  const PixelSequence numbers(sequence, seed, replicate);
  const owen_sobol::Keys keys = numbers.keys(dimension::lens);
  const auto map = [&](auto&& draw) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const owen_sobol::Pair u = draw(first + static_cast<std::uint32_t>(i));
      const auto d = concentric_disk(unit_double(u.x), unit_double(u.y));
      points[i] = {d.x, d.y};
    }
  };
  if (sequence == Sequence::Sobol)
    map([&](std::uint32_t i) { return owen_sobol::pair(i, keys); });
  else if (sequence == Sequence::Halton)
    map([&](std::uint32_t i) { return numbers.pair(i, dimension::lens); });
  else
    map([&](std::uint32_t i) { return PixelSequence::independent(i, keys.order); });
}

void fill_pupil(const PupilSampler& sampler, Sequence sequence, std::uint64_t seed, std::uint32_t replicate,
                std::uint32_t first, std::vector<Eigen::Vector2d>& points, std::vector<double>& weights) {
  const PixelSequence numbers(sequence, seed, replicate);
  weights.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const owen_sobol::Pair u = numbers.pair(first + static_cast<std::uint32_t>(i), dimension::lens);
    const WeightedPoint drawn = sampler.at(unit_double(u.x), unit_double(u.y));
    points[i] = drawn.point;
    weights[i] = drawn.weight;
  }
}

std::vector<WeightedPoint> disk_quadrature(int radial, int azimuthal) {
  std::vector<WeightedPoint> points;
  points.reserve(static_cast<std::size_t>(radial) * azimuthal);
  for (const Node& node : gauss_legendre(radial)) {
    const double radius = std::sqrt(node.x);
    for (int k = 0; k < azimuthal; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + 0.5) / azimuthal;
      points.push_back({{radius * std::cos(angle), radius * std::sin(angle)}, node.weight / azimuthal});
    }
  }
  return points;
}

}  // namespace sturm
