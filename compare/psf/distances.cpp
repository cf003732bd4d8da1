#include "compare/psf/distances.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

namespace sturm {

namespace {

using Cell = std::pair<long, long>;

struct Masses {
  double p = 0.0, q = 0.0;
};

struct Mass {
  double place, mass;  // of q with a minus sign
};

}  // namespace

TotalVariation total_variation(const PointSpread& p, const PointSpread& q, double cell_arcmin) {
  std::map<Cell, Masses> cells;  // ordered, so that the sums have the same bits everywhere
  const auto cell_of = [&](const Eigen::Vector2d& x) -> Masses& {
    return cells[{static_cast<long>(std::floor(x.x() / cell_arcmin)),
                  static_cast<long>(std::floor(x.y() / cell_arcmin))}];
  };
  for (std::size_t i = 0; i < p.points.size(); ++i) cell_of(p.points[i]).p += p.weights[i];
  for (std::size_t i = 0; i < q.points.size(); ++i) cell_of(q.points[i]).q += q.weights[i];
  TotalVariation result;
  const double per_ray =
      p.independent_rays > 0.0 && q.independent_rays > 0.0 ? 1.0 / p.independent_rays + 1.0 / q.independent_rays : 0.0;
  double noise = 0.0;
  for (const auto& [cell, mass] : cells) {
    result.value += 0.5 * std::abs(mass.p - mass.q);
    const double mean = 0.5 * (mass.p + mass.q);
    noise += 0.5 * std::sqrt(2.0 / std::numbers::pi * mean * std::max(0.0, 1.0 - mean) * per_ray);
  }
  if (per_ray > 0.0) result.expected_of_noise = noise;
  return result;
}

double projected_wasserstein(const PointSpread& p, const PointSpread& q, const Eigen::Vector2d& direction) {
  std::vector<Mass> masses;
  masses.reserve(p.points.size() + q.points.size());
  for (std::size_t i = 0; i < p.points.size(); ++i) masses.push_back({direction.dot(p.points[i]), p.weights[i]});
  for (std::size_t i = 0; i < q.points.size(); ++i) masses.push_back({direction.dot(q.points[i]), -q.weights[i]});
  std::sort(masses.begin(), masses.end(), [](const Mass& a, const Mass& b) { return a.place < b.place; });
  double distance = 0.0, difference = 0.0;
  for (std::size_t i = 0; i + 1 < masses.size(); ++i) {
    difference += masses[i].mass;
    distance += std::abs(difference) * (masses[i + 1].place - masses[i].place);
  }
  return distance;
}

double sliced_wasserstein(const PointSpread& p, const PointSpread& q, int directions) {
  std::vector<double> distances(static_cast<std::size_t>(directions));
  tbb::parallel_for(0, directions, [&](int k) {
    const double angle = std::numbers::pi * k / directions;
    distances[static_cast<std::size_t>(k)] = projected_wasserstein(p, q, {std::cos(angle), std::sin(angle)});
  });
  return std::accumulate(distances.begin(), distances.end(), 0.0) / directions;
}

}  // namespace sturm
