#pragma once
#include <optional>
#include <span>
#include <vector>

#include "compare/psf/point_spread.h"

namespace sturm {

/// A measured number and, where it can be told, its standard error.
struct WithError {
  double value = 0.0;
  std::optional<double> standard_error;
};

/// Share of the light within each radius [arcmin] of the centroid: of points, and of the areas of a picture's pixels
/// (compare/psf/pixel_light.h). Standard error √(p(1 − p)/N) for N independent rays.
std::vector<WithError> encircled_energy(const PointSpread& spread, std::span<const double> radii_arcmin);

/// Radius about the centroid [arcmin] that holds the share `energy` in (0, 1) of the light. Standard error: half the
/// distance between the radii of p ± √(p(1 − p)/N), for N independent rays.
WithError encircled_energy_radius(const PointSpread& spread, double energy);

}  // namespace sturm
