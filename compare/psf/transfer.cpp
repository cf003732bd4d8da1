#include "compare/psf/transfer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/statistics/sinc.h"

namespace sturm {

namespace {

constexpr double arcmin_per_degree = 60.0;

/// (cos, sin) of an angle in degrees; exact on the axes.
Eigen::Vector2d direction(double degrees) {
  if (std::fmod(degrees, 180.0) == 0.0) return {1.0, 0.0};
  if (std::fmod(degrees, 180.0) == 90.0) return {0.0, 1.0};
  const double a = degrees * std::numbers::pi / 180.0;
  return {std::cos(a), std::sin(a)};
}

}  // namespace

std::complex<double> optical_transfer(const PointSpread& spread, double frequency_cpd, double direction_deg) {
  const Eigen::Vector2d wave = frequency_cpd / arcmin_per_degree * direction(direction_deg);  // [cycles/arcmin]
  const Eigen::Vector2d middle = spread.centroid();
  double real = 0.0, imaginary = 0.0;
  for (std::size_t i = 0; i < spread.points.size(); ++i) {
    const double phase = -2.0 * std::numbers::pi * wave.dot(spread.points[i] - middle);
    real += spread.weights[i] * std::cos(phase);
    imaginary += spread.weights[i] * std::sin(phase);
  }
  const double pixel = sinc(wave.x() * spread.cell_arcmin) * sinc(wave.y() * spread.cell_arcmin);
  return std::complex<double>(real, imaginary) / pixel;
}

std::optional<WithError> modulation_transfer(const PointSpread& spread, double frequency_cpd, double direction_deg) {
  const Eigen::Vector2d per_cell = frequency_cpd / arcmin_per_degree * spread.cell_arcmin * direction(direction_deg);
  if (per_cell.cwiseAbs().maxCoeff() >= 0.5) return std::nullopt;
  const std::complex<double> otf = optical_transfer(spread, frequency_cpd, direction_deg);
  WithError result{std::abs(otf), std::nullopt};
  if (spread.independent_rays > 0.0) {
    const std::complex<double> twice = optical_transfer(spread, 2.0 * frequency_cpd, direction_deg);
    const double along = 0.5 * (1.0 + std::real(twice * std::polar(1.0, -2.0 * std::arg(otf))));
    result.standard_error = std::sqrt(std::max(0.0, along - std::norm(otf)) / spread.independent_rays);
  }
  return result;
}

}  // namespace sturm
