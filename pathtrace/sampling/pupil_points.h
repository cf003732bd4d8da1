#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "io/specs/ray_bundle_spec.h"
#include "pathtrace/sampling/pupil_sampler.h"

namespace sturm {

/// Points first … first + n − 1 of replicate `replicate`, uniform over the unit disc (concentric map of Shirley &
/// Chiu). Replicates are independent scramblings of one sequence, or independent random points.
void fill_unit_disk(Sequence sequence, std::uint64_t seed, std::uint32_t replicate, std::uint32_t first,
                    std::vector<Eigen::Vector2d>& points);

/// The same spread over the pupil by `sampler`; `weights` gets their weights, of mean 1.
void fill_pupil(const PupilSampler& sampler, Sequence sequence, std::uint64_t seed, std::uint32_t replicate,
                std::uint32_t first, std::vector<Eigen::Vector2d>& points, std::vector<double>& weights);

/// Quadrature over the unit disc: Gauss–Legendre in r², equally spaced angles; the weights add up to 1. Exact for
/// polynomials of degree 4·radial − 2 in r and trigonometric degree azimuthal − 1.
std::vector<WeightedPoint> disk_quadrature(int radial, int azimuthal);

}  // namespace sturm
