#include "wavefront/psf/transfer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lensmodel/gauss_legendre.h"

namespace sturm {

namespace {

/// Sum over the overlap of two pupils of radius a that stand `shift` apart; `value` of both pupil points. In the
/// direction across the shift the substitution v = a sin t removes the root at the ends.
template <class Value>
std::complex<double> over_overlap(double a, const Eigen::Vector2d& shift, const std::vector<QuadratureNode>& nodes,
                                  const Value& value) {
  const double distance = shift.norm();
  const Eigen::Vector2d along =
      distance > 0.0 ? Eigen::Vector2d(shift / distance) : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  const Eigen::Vector2d across(-along.y(), along.x());
  const double end = std::acos(std::min(1.0, 0.5 * distance / a));
  std::complex<double> sum = 0.0;
  for (const QuadratureNode& outer : nodes) {
    const double t = end * outer.x, v = a * std::sin(t), extent = a * std::cos(t) - 0.5 * distance;
    std::complex<double> line = 0.0;
    for (const QuadratureNode& inner : nodes) {
      const Eigen::Vector2d q = extent * inner.x * along + v * across;
      line += inner.weight * value(Eigen::Vector2d(q - 0.5 * shift), Eigen::Vector2d(q + 0.5 * shift));
    }
    sum += outer.weight * end * a * std::cos(t) * extent * line;
  }
  return sum;
}

double amplitudes(const PupilWave& pupil, const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  return pupil.stiles_crawford_per_m2 == 0.0 ? 1.0 : std::sqrt(pupil.intensity(p.squaredNorm() + q.squaredNorm()));
}

}  // namespace

std::complex<double> wave_transfer(const PupilWave& pupil, const Light& light, double vergence_D,
                                   const Eigen::Vector2d& frequency) {
  // Gauss's rule needs about half as many nodes as the phase has radians; the phase differs by 2π ν·∇W.
  const double radians =
      2.0 * std::numbers::pi * frequency.norm() * std::numbers::sqrt2 * pupil.largest_slope(light, vergence_D);
  const std::vector<QuadratureNode> nodes = gauss_legendre(std::min(512, 32 + static_cast<int>(0.8 * radians)));
  std::complex<double> sum = 0.0;
  for (const SpectralLine& line : light) {
    const double wavelength_m = metres_per_nanometre * line.wavelength_nm;
    const Eigen::Vector2d shift = wavelength_m * frequency;
    if (shift.norm() >= 2.0 * pupil.radius_m) continue;
    const double vergence = pupil.vergence_at(line.wavelength_nm, vergence_D);
    sum += line.weight / pupil.area_m2() *
           over_overlap(pupil.radius_m, shift, nodes, [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
             return std::polar(amplitudes(pupil, p, q), 2.0 * std::numbers::pi / wavelength_m *
                                                            (pupil.height(p, vergence) - pupil.height(q, vergence)));
           });
  }
  return sum;
}

double unaberrated_transfer(const PupilWave& pupil, const Light& light, double frequency) {
  static const std::vector<QuadratureNode> nodes = gauss_legendre(24);
  double sum = 0.0;
  for (const SpectralLine& line : light) {
    const Eigen::Vector2d shift(metres_per_nanometre * line.wavelength_nm * frequency, 0.0);
    const double s = 0.5 * shift.x() / pupil.radius_m;  // of the cutoff
    if (s >= 1.0) continue;
    if (pupil.stiles_crawford_per_m2 == 0.0) {
      sum += line.weight * 2.0 / std::numbers::pi * (std::acos(s) - s * std::sqrt(1.0 - s * s));
      continue;
    }
    const auto both = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
      return std::complex<double>(amplitudes(pupil, p, q));
    };
    sum += line.weight / pupil.area_m2() * over_overlap(pupil.radius_m, shift, nodes, both).real();
  }
  return sum;
}

}  // namespace sturm
