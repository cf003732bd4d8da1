#include "wavefront/psf/ray_fan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lensmodel/gauss_legendre.h"
#include "wavefront/psf/pupil_wave.h"

namespace sturm {

namespace {

/// 1/φ and 1/φ² of the root φ of φ³ = φ + 1, which fill two dimensions most evenly.
constexpr double step_of_radius = 0.7548776662466927, step_of_angle = 0.5698402909980532;

double fraction(double start, double step, std::size_t i) {
  const double value = start + step * static_cast<double>(i);
  return value - std::floor(value);
}

std::size_t points_for(const Light& light, std::size_t count) {
  constexpr std::size_t rays_per_count = 8;
  return std::min(count, std::max(std::size_t{1}, rays_per_count * count / light.size()));
}

}  // namespace

RayFan::RayFan(const PupilWave& pupil, const Light& light, std::size_t count, const PupilSector& sector)
    : points_(points_for(light, count)), gradients_(points_.size()) {
  for (const SpectralLine& line : light)
    if (line.weight > 0.0) lines_.push_back({line.weight, pupil.vergence_at(line.wavelength_nm, 0.0)});
  const double q = std::numbers::ln10 * pupil.stiles_crawford_per_m2 * pupil.radius_m * pupil.radius_m;
  const double width = sector.outer - sector.inner;
  tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t i) {
    const double u = fraction(0.5, step_of_radius, i),
                 angle = two_pi * std::lerp(sector.from, sector.to, fraction(0.5, step_of_angle, i));
    const double t = sector.inner + (q == 0.0 ? width * u : -std::log1p(u * std::expm1(-q * width)) / q);  // (r/a)²
    points_[i] = pupil.radius_m * std::sqrt(t) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    gradients_[i] = pupil.gradient(points_[i], 0.0);
  });
}

double ray_radius(const RayFan& fan, double vergence_D, const Eigen::Vector2d& centre, double share) {
  constexpr std::size_t bins = 1 << 18;
  double largest = 0.0;
  fan.for_each(vergence_D,
               [&](const Eigen::Vector2d& x, double) { largest = std::max(largest, (x - centre).squaredNorm()); });
  largest = std::sqrt(largest);
  if (largest == 0.0) return 0.0;
  std::vector<double> energy(bins + 1, 0.0);
  fan.for_each(vergence_D, [&](const Eigen::Vector2d& x, double weight) {
    energy[static_cast<std::size_t>((x - centre).norm() / largest * bins)] += weight;
  });
  double sum = 0.0;
  std::size_t bin = 0;
  while (bin < bins && sum + energy[bin] < share) sum += energy[bin++];
  const double within = energy[bin] > 0.0 ? std::min(1.0, (share - sum) / energy[bin]) : 0.0;
  return largest * (static_cast<double>(bin) + within) / bins;
}

PsfCells cells_of(const RayFan& fan, double vergence_D, double cell_rad, int side) {
  PsfCells cells{cell_rad, Eigen::MatrixXd::Zero(side, side)};
  fan.for_each(vergence_D, [&](const Eigen::Vector2d& x, double share) {
    const double column = x.x() / cell_rad + 0.5 * side, row = x.y() / cell_rad + 0.5 * side;
    if (row >= 0.0 && row < side && column >= 0.0 && column < side)
      cells.energy(static_cast<int>(row), static_cast<int>(column)) += share;
  });
  return cells;
}

std::complex<double> ray_transfer(const RayFan& fan, double vergence_D, const Eigen::Vector2d& frequency) {
  constexpr std::size_t most = std::size_t{1} << 18;
  std::complex<double> sum = 0.0;
  fan.for_each(vergence_D, most / fan.wavelengths(),
               [&](const Eigen::Vector2d& x, double share) { sum += std::polar(share, -two_pi * frequency.dot(x)); });
  return sum;
}

RayMoments ray_moments(const PupilWave& pupil, const Light& light, double vergence_D) {
  constexpr int radial = 32, azimuthal = 96;  // exact for slopes of order 20, and for e^(−q r²) to rounding
  static const std::vector<QuadratureNode> nodes = gauss_legendre(radial);
  double weights = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
  for (const SpectralLine& line : light)
    for (const QuadratureNode& node : nodes)
      for (int k = 0; k < azimuthal; ++k) {
        const double r2 = 0.5 * (1.0 + node.x) * pupil.radius_m * pupil.radius_m, angle = two_pi * k / azimuthal;
        const double weight = line.weight * node.weight * pupil.intensity(r2);
        const Eigen::Vector2d p = std::sqrt(r2) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        const Eigen::Vector2d x = pupil.gradient(p, pupil.vergence_at(line.wavelength_nm, vergence_D));
        weights += weight;
        mean += weight * x;
        square += weight * x * x.transpose();
      }
  mean /= weights;
  return {mean, square / weights - mean * mean.transpose()};
}

}  // namespace sturm
