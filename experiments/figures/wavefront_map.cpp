#include "experiments/figures/wavefront_map.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/figures/lens_maps.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"
#include "reports/markup/pictures.h"

namespace sturm {

namespace {

/// The wave at the eye's pupil, and what of it piston and tilt are.
struct ShownWave {
  ZernikeWave wave;
  std::array<PlanePolynomial, 3> left_out{zernike_polynomial(0), zernike_polynomial(1), zernike_polynomial(2)};

  explicit ShownWave(const Eye& eye)
      : wave(eye.wavefront ? eye.wavefront->rescaled(eye.pupil_radius_m)
                           : ZernikeWave::of_power(eye.correction, eye.pupil_radius_m)) {}

  double coefficient(std::size_t j) const { return j < wave.coefficients().size() ? wave.coefficients()[j] : 0.0; }

  /// At the place (x, y) in radii of the pupil [m].
  double height(double x, double y) const {
    double sum = wave.height(wave.radius_m() * Eigen::Vector2d(x, y));
    for (std::size_t j = 0; j < left_out.size(); ++j) sum -= coefficient(j) * left_out[j](x, y);
    return sum;
  }

  double root_mean_square() const {
    double square = 0.0;
    for (std::size_t j = left_out.size(); j < wave.coefficients().size(); ++j)
      square += coefficient(j) * coefficient(j);
    return std::sqrt(square);
  }
};

}  // namespace

LensMap wavefront_map(const Eye& eye, const std::string& name) {
  if (!(eye.pupil_radius_m > 0.0)) throw std::invalid_argument("a pinhole has no wavefront");
  const ShownWave wave(eye);
  LensMap map;
  map.unit = "µm";
  map.rim_radius_mm = eye.pupil_radius_m / metres_per_millimetre;
  map.values = Eigen::MatrixXd::Constant(lens_map_samples, lens_map_samples, std::numeric_limits<double>::quiet_NaN());
  double largest = 0.0;
  for (int row = 0; row < lens_map_samples; ++row)
    for (int column = 0; column < lens_map_samples; ++column) {
      const auto at = [](int i) { return 2.0 * i / (lens_map_samples - 1) - 1.0; };
      const double x = at(column), y = at(row);
      if (std::hypot(x, y) > 1.0) continue;
      map.values(row, column) = wave.height(x, y) / metres_per_micrometre;
      largest = std::fmax(largest, std::abs(map.values(row, column)));
    }
  map.contour_step = largest > 0.0 ? round_length_above(largest / 16.0) : 1.0;
  map.title = "wavefront of " + name + "\\nrms " + plain_number(wave.root_mean_square() / metres_per_micrometre, 3) +
              " µm over " + plain_number(2.0 * map.rim_radius_mm, 4) + " mm";
  return map;
}

}  // namespace sturm
