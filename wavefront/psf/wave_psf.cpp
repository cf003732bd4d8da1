#include "wavefront/psf/wave_psf.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

#include "wavefront/psf/disc_area.h"
#include "wavefront/psf/pupil_wave.h"
#include "wavefront/psf/transform.h"

namespace sturm {

namespace {

/// PSF [1/rad²] on the grid, X = 0 first, and what it would be there without aberration.
struct Spread {
  cv::Mat1d density;
  double unaberrated = 0.0;
};

/// The pupil's field of one wavelength times the area of each cell, in the corner of the grid: a shift changes phases
/// of the spread only. Memory is kept from one wavelength to the next.
struct PupilField {
  cv::Mat2d field;
  int rows = 0;
  double scale = 0.0;        ///< of |transform|² [1/(m⁴ rad²)]
  double unaberrated = 0.0;  ///< as in Spread
};

void fill(PupilField& p, const PupilWave& pupil, const SpectralLine& line, double vergence_D,
          const WaveSampling& sampling) {
  const double wavelength_m = metres_per_nanometre * line.wavelength_nm;
  const double vergence = pupil.vergence_at(line.wavelength_nm, vergence_D);
  const double step = wavelength_m * sampling.frequency_step, half = 0.5 * step, cell = step * step;
  const int side = std::min(sampling.grid, 2 * static_cast<int>(std::ceil(pupil.radius_m / step)));
  p.field.create(sampling.grid, sampling.grid);
  p.rows = side;
  std::vector<double> sums(static_cast<std::size_t>(side), 0.0);
  tbb::parallel_for(0, side, [&](int row) {
    p.field.row(row).setTo(cv::Scalar::all(0.0));
    const double y = (row - side / 2 + 0.5) * step;
    const std::vector<double> wave = pupil.wave.height_in_x(y / pupil.wave.radius_m());
    for (int column = 0; column < side; ++column) {
      const double x = (column - side / 2 + 0.5) * step;
      const double area = area_within_disc(std::abs(x) - half, std::abs(x) + half, std::abs(y) - half,
                                           std::abs(y) + half, pupil.radius_m);
      if (area <= 1e-9 * cell) continue;
      const double amplitude = area * std::sqrt(pupil.intensity(x * x + y * y));
      const double x_of_radius = x / pupil.wave.radius_m();
      double height = 0.0;
      for (std::size_t i = wave.size(); i-- > 0;) height = height * x_of_radius + wave[i];
      const double phase = two_pi / wavelength_m * (height - 0.5 * vergence * (x * x + y * y));
      p.field(row, column) = {amplitude * std::cos(phase), amplitude * std::sin(phase)};
      sums[static_cast<std::size_t>(row)] += amplitude;
    }
  });
  double sum = 0.0;
  for (const double of_row : sums) sum += of_row;
  p.scale = line.weight / (wavelength_m * wavelength_m * pupil.area_m2());
  p.unaberrated = p.scale * sum * sum;
}

/// All wavelengths together; groups of them side by side, added in order.
Spread spread_of(const PupilWave& pupil, const Light& light, double vergence_D, const WaveSampling& sampling) {
  constexpr std::size_t group = 4;
  Spread total{cv::Mat1d(sampling.grid, sampling.grid, 0.0), 0.0};
  std::vector<PupilField> fields(std::min(group, light.size()));
  for (std::size_t first = 0; first < light.size(); first += group) {
    const std::size_t count = std::min(group, light.size() - first);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      fill(fields[i], pupil, light[first + i], vergence_D, sampling);
      transform(fields[i].field, fields[i].rows);
    });
    tbb::parallel_for(0, sampling.grid, [&](int row) {
      double* density = total.density[row];
      for (std::size_t i = 0; i < count; ++i) {
        const cv::Vec2d* u = fields[i].field[row];
        for (int column = 0; column < sampling.grid; ++column)
          density[column] += fields[i].scale * (u[column][0] * u[column][0] + u[column][1] * u[column][1]);
      }
    });
    for (std::size_t i = 0; i < count; ++i) total.unaberrated += fields[i].unaberrated;
  }
  return total;
}

/// The largest value of the spread, between the grid's points by ever finer grids of 3 × 3: to 1/64 of a pixel.
void find_peak(WavePsf& psf, const cv::Mat1d& density) {
  int at[2] = {0, 0};
  cv::minMaxIdx(density, nullptr, nullptr, nullptr, at);
  const int n = psf.sampling.grid;
  double step = psf.sampling.pixel_rad();
  psf.peak = {step * (at[1] < n / 2 ? at[1] : at[1] - n), step * (at[0] < n / 2 ? at[0] : at[0] - n)};
  double best = psf.density(psf.peak);
  for (int round = 0; round < 6; ++round) {
    const Eigen::Vector2d centre = psf.peak;
    step *= 0.5;
    for (int i = -1; i <= 1; ++i)
      for (int k = -1; k <= 1; ++k) {
        const Eigen::Vector2d x = centre + step * Eigen::Vector2d(k, i);
        if (const double value = psf.density(x); value > best) {
          best = value;
          psf.peak = x;
        }
      }
  }
  psf.strehl_peak = best / psf.reference_peak;
}

}  // namespace

double WavePsf::density(const Eigen::Vector2d& x) const {
  const double f = sampling.frequency_step;
  Eigen::VectorXcd columns(highest + 1), rows(2 * highest + 1);
  for (int k = 0; k <= highest; ++k) columns[k] = std::polar(k == 0 ? 1.0 : 2.0, two_pi * f * k * x.x());
  for (int k = -highest; k <= highest; ++k) rows[highest + k] = std::polar(1.0, two_pi * f * k * x.y());
  const Eigen::VectorXcd along = otf * columns;
  return f * f * rows.cwiseProduct(along).sum().real();
}

WavePsf wave_psf(const PupilWave& pupil, const Light& light, double vergence_D, const WaveSampling& sampling) {
  const Spread spread = spread_of(pupil, light, vergence_D, sampling);
  double shortest = light.front().wavelength_nm;
  for (const SpectralLine& line : light) shortest = std::min(shortest, line.wavelength_nm);
  const double cutoff = 2.0 * pupil.radius_m / (metres_per_nanometre * shortest);
  const int n = sampling.grid;
  const int highest = std::min(n / 2 - 1, static_cast<int>(std::ceil(cutoff / sampling.frequency_step)) + 1);
  WavePsf psf{sampling,
              highest,
              Eigen::MatrixXcd(2 * highest + 1, highest + 1),
              spread.density(0, 0) / spread.unaberrated,
              0.0,
              {0, 0},
              spread.unaberrated};
  const cv::Mat2d transformed = transform(spread.density);
  const double pixel_area = sampling.pixel_rad() * sampling.pixel_rad();
  for (int ky = -highest; ky <= highest; ++ky)
    for (int kx = 0; kx <= highest; ++kx) {
      const cv::Vec2d& value = transformed((ky + n) % n, kx);
      psf.otf(highest + ky, kx) = pixel_area * std::complex<double>(value[0], value[1]);
    }
  find_peak(psf, spread.density);
  return psf;
}

}  // namespace sturm
