#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "io/ray_bundle_spec.h"

namespace sturm {

/// A point of the unit disc and its share of the pupil's light.
struct WeightedPoint {
  Eigen::Vector2d point;
  double weight;  ///< all weights of a rule add up to 1
};

/// Points first … first + n − 1 of replicate `replicate`, uniform over the unit disc (concentric map of Shirley & Chiu).
/// Replicates are independent scramblings of one sequence, or independent random points.
void fill_unit_disk(Sequence sequence, std::uint64_t seed, std::uint32_t replicate, std::uint32_t first,
                    std::vector<Eigen::Vector2d>& points);

/// Quadrature over the unit disc: Gauss–Legendre in r², equally spaced angles. Exact for polynomials of degree 4·radial − 2 in r
/// and trigonometric degree azimuthal − 1.
std::vector<WeightedPoint> disk_quadrature(int radial, int azimuthal);

}  // namespace sturm
