#include "compare/psf/encircled_energy.h"

#include <algorithm>
#include <cmath>

#include "compare/psf/pixel_light.h"

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

/// Light within a radius, of points or of a picture.
class Curve {
 public:
  explicit Curve(const PointSpread& spread) {
    if (spread.cell_arcmin > 0.0)
      light_.emplace(spread);
    else
      rings_ = sorted_rings(spread);
  }

  double within(double radius) const {
    if (light_) return light_->within(radius);
    double sum = 0.0;
    for (const Ring& ring : rings_) {
      if (ring.radius > radius) break;
      sum += ring.weight;
    }
    return sum;
  }

  double radius_of(double energy) const { return light_ ? light_->radius_of(energy) : radius_at(rings_, energy); }

 private:
  std::optional<PixelLight> light_;
  std::vector<Ring> rings_;
};

double binomial_error(double p, double rays) {
  return std::sqrt(std::max(0.0, p * (1.0 - p)) / rays);
}

}  // namespace

std::vector<WithError> encircled_energy(const PointSpread& spread, std::span<const double> radii_arcmin) {
  const Curve curve(spread);
  std::vector<WithError> result;
  for (const double radius : radii_arcmin) {
    WithError e;
    e.value = curve.within(radius);
    if (spread.independent_rays > 0.0) e.standard_error = binomial_error(e.value, spread.independent_rays);
    result.push_back(e);
  }
  return result;
}

WithError encircled_energy_radius(const PointSpread& spread, double energy) {
  const Curve curve(spread);
  WithError e{curve.radius_of(energy), std::nullopt};
  if (spread.independent_rays > 0.0) {
    const double error = binomial_error(energy, spread.independent_rays);
    e.standard_error =
        0.5 * (curve.radius_of(std::min(1.0, energy + error)) - curve.radius_of(std::max(0.0, energy - error)));
  }
  return e;
}

}  // namespace sturm
