#pragma once
#include <optional>
#include <vector>

#include "wavefront/psf/spread_kernel.h"
#include "wavefront/psf/wave_measures.h"

namespace sturm {

/// Rays through low-discrepancy points of a pupil, each of equal energy and of one wavelength of the light; where they
/// land is linear in the vergence error, so one fan serves all distances.
class RayFan {
 public:
  /// The first `count` points of a Kronecker sequence [Roberts2018] in (r², angle, wavelength); Stiles–Crawford and the
  /// light's weights are in their density. Same bits for any number of threads.
  RayFan(const PupilWave& pupil, const Light& light, std::size_t count);

  std::size_t size() const { return points_.size(); }
  const Eigen::Vector2d& pupil_point(std::size_t i) const { return points_[i]; }

  /// X = +∇W [rad] with the vergence error V of the target [D].
  Eigen::Vector2d landing(std::size_t i, double vergence_D) const { return gradients_[i] - vergence_D * points_[i]; }

 private:
  std::vector<Eigen::Vector2d> points_;     ///< [m]
  std::vector<Eigen::Vector2d> gradients_;  ///< ∇W in each ray's own wavelength [rad]
};

/// Number of rays of which a fan shows no noise.
inline constexpr std::size_t usual_ray_count = std::size_t{1} << 20;

/// The radius [rad] about a centre within which a share of the rays lands.
double ray_radius(const RayFan& fan, double vergence_D, const Eigen::Vector2d& centre, double share);

/// The share of rays in side × side cells.
PsfCells cells_of(const RayFan& fan, double vergence_D, double cell_rad, int side);

/// Transfer function of the rays at a frequency [cycles/rad], by the first 2¹⁷ of them at most.
std::complex<double> ray_transfer(const RayFan& fan, double vergence_D, const Eigen::Vector2d& frequency);

/// Exact first and second moments of the rays.
struct RayMoments {
  Eigen::Vector2d centroid;    ///< [rad]
  Eigen::Matrix2d covariance;  ///< about the centroid [rad²]
};

/// By quadrature over the pupil, without any ray: exact to rounding for uniform pupils.
RayMoments ray_moments(const PupilWave& pupil, const Light& light, double vergence_D);

}  // namespace sturm
