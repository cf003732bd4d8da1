#include "wavefront/psf/wave_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lensmodel/units.h"
#include "wavefront/psf/pupil_wave.h"
#include "wavefront/psf/transfer.h"

namespace sturm {

namespace {

constexpr int bins_per_step = 32;

/// sin(πx)/(πx)
double sinc(double x) {
  return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

double contrast_sensitivity(double cycles_per_degree) {
  const double f = 0.114 * cycles_per_degree;
  return (0.0192 + f) * std::exp(-std::pow(f, 1.1));
}

}  // namespace

WaveEnergy::WaveEnergy(const WavePsf& psf, const Eigen::Vector2d& centre)
    : bin_(psf.sampling.frequency_step / bins_per_step),
      masses_(static_cast<std::size_t>(std::ceil(std::numbers::sqrt2 * psf.highest * bins_per_step)) + 2, 0.0),
      largest_(0.5 * psf.sampling.window_rad() - centre.cwiseAbs().maxCoeff()) {
  const double f = psf.sampling.frequency_step;
  for (int kx = 0; kx <= psf.highest; ++kx)
    for (int ky = -psf.highest; ky <= psf.highest; ++ky) {
      const std::complex<double> about_centre =
          psf.otf(psf.highest + ky, kx) * std::polar(1.0, two_pi * f * (kx * centre.x() + ky * centre.y()));
      const double mass = (kx == 0 ? 1.0 : 2.0) * f * f * about_centre.real();
      const double place = std::hypot(kx, ky) * bins_per_step;
      const auto below = static_cast<std::size_t>(place);
      masses_[below] += mass * (1.0 - (place - static_cast<double>(below)));
      masses_[below + 1] += mass * (place - static_cast<double>(below));
    }
}

double WaveEnergy::within(double radius) const {
  double sum = masses_[0] * std::numbers::pi * radius * radius;
  for (std::size_t i = 1; i < masses_.size(); ++i) {
    if (masses_[i] == 0.0) continue;
    const double frequency = bin_ * static_cast<double>(i);
    sum += masses_[i] * radius / frequency * ::j1(two_pi * radius * frequency);
  }
  return sum;
}

std::optional<double> WaveEnergy::radius(double share) const {
  double low = 0.0, high = largest_;
  if (!(within(high) >= share)) return std::nullopt;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (within(middle) >= share ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double visual_strehl(const WavePsf& psf, const PupilWave& pupil, const Light& light) {
  constexpr double last_seen_cpd = 150.0;  // the sensitivity is 1e-9 of its maximum there
  const double f = psf.sampling.frequency_step;
  const int highest = std::min(psf.highest, static_cast<int>(last_seen_cpd / (f * radians_per_degree)));
  // The unaberrated transfer function depends on |ν| alone: once for each step, linear in between.
  std::vector<double> reference(static_cast<std::size_t>(std::numbers::sqrt2 * highest) + 3);
  for (std::size_t i = 0; i < reference.size(); ++i)
    reference[i] = unaberrated_transfer(pupil, light, f * static_cast<double>(i));
  double seen = 0.0, best = 0.0;
  for (int kx = 0; kx <= highest; ++kx)
    for (int ky = -highest; ky <= highest; ++ky) {
      const double distance = std::hypot(kx, ky);
      const auto below = static_cast<std::size_t>(distance);
      const double weight = (kx == 0 ? 1.0 : 2.0) * contrast_sensitivity(f * distance * radians_per_degree);
      seen += weight * psf.otf(psf.highest + ky, kx).real();
      best += weight * std::lerp(reference[below], reference[below + 1], distance - static_cast<double>(below));
    }
  return seen / best;
}

PsfCells cells_of(const WavePsf& psf, double cell, int side) {
  const double f = psf.sampling.frequency_step, edge = 0.5 * psf.sampling.window_rad();
  const int highest = psf.highest, middle = side / 2;
  Eigen::MatrixXcd rows(side, 2 * highest + 1), columns(highest + 1, side);
  for (int i = 0; i < side; ++i) {
    const double first = std::clamp(cell * (i - middle - 0.5), -edge, edge),
                 last = std::clamp(cell * (i - middle + 0.5), -edge, edge);
    const double x = 0.5 * (first + last), width = last - first;
    for (int k = -highest; k <= highest; ++k)
      rows(i, highest + k) = std::polar(f * width, two_pi * f * k * x) * sinc(f * k * width);
    for (int k = 0; k <= highest; ++k)
      columns(k, i) = std::polar((k == 0 ? 1.0 : 2.0) * f * width, two_pi * f * k * x) * sinc(f * k * width);
  }
  const Eigen::MatrixXcd half = rows * psf.otf;
  return {cell, (half * columns).real()};
}

double total_variation(const PsfCells& p, const PsfCells& q) {
  return 0.5 * ((p.energy - q.energy).cwiseAbs().sum() + std::abs(p.outside() - q.outside()));
}

}  // namespace sturm
