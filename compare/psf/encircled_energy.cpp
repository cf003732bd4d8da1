#include "compare/psf/encircled_energy.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

struct Ring {
  double radius, weight;
};

std::vector<Ring> sorted_rings(const PointSpread& spread) {
  const Eigen::Vector2d middle = spread.centroid();
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < spread.points.size(); ++i)
    rings.push_back({(spread.points[i] - middle).norm(), spread.weights[i]});
  std::sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) { return a.radius < b.radius; });
  return rings;
}

/// Radius where the summed weight passes `energy`; each point counts half before its radius, so that the curve is the
/// trapezoid through them.
double radius_at(const std::vector<Ring>& rings, double energy) {
  double before = 0.0, last_sum = 0.0, last_radius = 0.0;
  for (const Ring& ring : rings) {
    const double sum = before + 0.5 * ring.weight;
    if (sum >= energy) {
      const double t = sum > last_sum ? (energy - last_sum) / (sum - last_sum) : 1.0;
      // Area, not radius, grows evenly with the energy of a smooth spot.
      return std::sqrt(last_radius * last_radius + t * (ring.radius * ring.radius - last_radius * last_radius));
    }
    before += ring.weight;
    last_sum = sum;
    last_radius = ring.radius;
  }
  return rings.back().radius;
}

double binomial_error(double p, double rays) {
  return std::sqrt(std::max(0.0, p * (1.0 - p)) / rays);
}

}  // namespace

std::vector<WithError> encircled_energy(const PointSpread& spread, std::span<const double> radii_arcmin) {
  const std::vector<Ring> rings = sorted_rings(spread);
  std::vector<WithError> curve;
  for (const double radius : radii_arcmin) {
    WithError e;
    for (const Ring& ring : rings) {
      if (ring.radius > radius) break;
      e.value += ring.weight;
    }
    if (spread.independent_rays > 0.0) e.standard_error = binomial_error(e.value, spread.independent_rays);
    curve.push_back(e);
  }
  return curve;
}

WithError encircled_energy_radius(const PointSpread& spread, double energy) {
  const std::vector<Ring> rings = sorted_rings(spread);
  WithError e{radius_at(rings, energy), std::nullopt};
  if (spread.independent_rays > 0.0) {
    const double error = binomial_error(energy, spread.independent_rays);
    e.standard_error =
        0.5 * (radius_at(rings, std::min(1.0, energy + error)) - radius_at(rings, std::max(0.0, energy - error)));
  }
  return e;
}

}  // namespace sturm
