#include "wavefront/psf/ray_fan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lensmodel/gauss_legendre.h"

namespace sturm {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
/// Steps of the radius, the angle and the wavelength.
struct Steps {
  double radius, angle, wavelength;
};
/// 1/φ, 1/φ² of the root φ of φ³ = φ + 1, which fill two dimensions most evenly; 1/φ, 1/φ², 1/φ³ of φ⁴ = φ + 1 for
/// three.
constexpr Steps steps_of_one_wavelength{0.7548776662466927, 0.5698402909980532, 0.0},
    steps_of_many{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

double fraction(double start, double step, std::size_t i) {
  const double value = start + step * static_cast<double>(i);
  return value - std::floor(value);
}

/// The line of the light on which u in [0, 1) falls.
const SpectralLine& line_at(const Light& light, double u) {
  double sum = 0.0;
  for (const SpectralLine& line : light) {
    sum += line.weight;
    if (u < sum) return line;
  }
  return light.back();
}

}  // namespace

RayFan::RayFan(const PupilWave& pupil, const Light& light, std::size_t count) : points_(count), gradients_(count) {
  const double q = std::numbers::ln10 * pupil.stiles_crawford_per_m2 * pupil.radius_m * pupil.radius_m;
  const Steps& steps = light.size() == 1 ? steps_of_one_wavelength : steps_of_many;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const double u = fraction(0.5, steps.radius, i), angle = two_pi * fraction(0.5, steps.angle, i);
    const double t = q == 0.0 ? u : -std::log1p(u * std::expm1(-q)) / q;  // (r/a)²
    points_[i] = pupil.radius_m * std::sqrt(t) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const SpectralLine& line = line_at(light, fraction(0.5, steps.wavelength, i));
    gradients_[i] = pupil.gradient(points_[i], pupil.vergence_at(line.wavelength_nm, 0.0));
  });
}

double ray_radius(const RayFan& fan, double vergence_D, const Eigen::Vector2d& centre, double share) {
  std::vector<double> squares(fan.size());
  for (std::size_t i = 0; i < fan.size(); ++i) squares[i] = (fan.landing(i, vergence_D) - centre).squaredNorm();
  const auto rank = std::min(fan.size() - 1, static_cast<std::size_t>(share * static_cast<double>(fan.size())));
  std::nth_element(squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(rank), squares.end());
  return std::sqrt(squares[rank]);
}

PsfCells cells_of(const RayFan& fan, double vergence_D, double cell_rad, int side) {
  PsfCells cells{cell_rad, Eigen::MatrixXd::Zero(side, side)};
  const double share = 1.0 / static_cast<double>(fan.size());
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const Eigen::Vector2d place = fan.landing(i, vergence_D) / cell_rad + Eigen::Vector2d::Constant(0.5 * side);
    if (!(place.minCoeff() >= 0.0 && place.maxCoeff() < side)) continue;
    cells.energy(static_cast<int>(place.y()), static_cast<int>(place.x())) += share;
  }
  return cells;
}

std::complex<double> ray_transfer(const RayFan& fan, double vergence_D, const Eigen::Vector2d& frequency) {
  const std::size_t count = std::min(fan.size(), std::size_t{1} << 17);
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += std::polar(1.0, -two_pi * frequency.dot(fan.landing(i, vergence_D)));
  return sum / static_cast<double>(count);
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
