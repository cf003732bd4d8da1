#pragma once
#include <algorithm>
#include <complex>
#include <vector>

#include "wavefront/psf/spread_kernel.h"
#include "wavefront/psf/wave_measures.h"

namespace sturm {

/// Rays through low-discrepancy points of a pupil or a part of it, one for each wavelength of the light; where they
/// land is linear in the vergence error, so one fan serves all distances.
class RayFan {
 public:
  /// The first points of a Kronecker sequence [Roberts2018] in (r², angle), all of the same energy: Stiles–Crawford is
  /// in their density. `count` points for one wavelength; for many, eight times as many rays in all. Same bits for any
  /// number of threads.
  RayFan(const PupilWave& pupil, const Light& light, std::size_t count, const PupilSector& sector = {});

  std::size_t points() const { return points_.size(); }      ///< each has one ray in every wavelength
  std::size_t wavelengths() const { return lines_.size(); }  ///< lines of the light
  const Eigen::Vector2d& pupil_point(std::size_t i) const { return points_[i]; }  ///< [m], frame of the pupil

  /// X = +∇W [rad] of a point's ray with the vergence error V [D], the chromatic one included.
  Eigen::Vector2d landing(std::size_t i, double vergence_D) const { return gradients_[i] - vergence_D * points_[i]; }

  /// `visit(X, share)` for the rays of the first points in every wavelength, with the vergence error of the target [D];
  /// the shares of those rays sum to 1.
  template <class Visit>
  void for_each(double vergence_D, std::size_t first_points, const Visit& visit) const {
    const std::size_t count = std::min(first_points, points_.size());
    for (const Line& line : lines_)
      for (std::size_t i = 0; i < count; ++i)
        visit(landing(i, vergence_D + line.chromatic_D), line.weight / static_cast<double>(count));
  }
  template <class Visit>
  void for_each(double vergence_D, const Visit& visit) const {
    for_each(vergence_D, points_.size(), visit);
  }  ///< the same for all points

 private:
  struct Line {
    double weight, chromatic_D;
  };
  std::vector<Line> lines_;
  std::vector<Eigen::Vector2d> points_;     ///< [m]
  std::vector<Eigen::Vector2d> gradients_;  ///< ∇W in the wavelength of focus [rad]
};

/// Number of points of which a fan shows no noise.
inline constexpr std::size_t usual_ray_count = std::size_t{1} << 20;

/// The radius [rad] about a centre within which a share of the rays lands.
double ray_radius(const RayFan& fan, double vergence_D, const Eigen::Vector2d& centre, double share);

/// The share of rays in side × side cells.
PsfCells cells_of(const RayFan& fan, double vergence_D, double cell_rad, int side);

/// Transfer function of the rays at a frequency [cycles/rad], by 2¹⁸ of them at most.
std::complex<double> ray_transfer(const RayFan& fan, double vergence_D, const Eigen::Vector2d& frequency);

/// Exact first and second moments of the rays.
struct RayMoments {
  Eigen::Vector2d centroid;    ///< [rad]
  Eigen::Matrix2d covariance;  ///< about the centroid [rad²]
};

/// By quadrature over the pupil, without any ray: exact to rounding for uniform pupils.
RayMoments ray_moments(const PupilWave& pupil, const Light& light, double vergence_D);

}  // namespace sturm
