#include "reports/fixture_eyes.h"

#include "lensmodel/ellipse.h"
#include "lensmodel/power_matrix.h"

namespace sturm::test {

using Eigen::Matrix2d;
using Eigen::Vector2d;

Matrix2d needed_vergence(const Prescription& rx, double distance_m) {
  return power_at_cornea(rx).matrix() + (1.0 / distance_m - accommodation_D) * Matrix2d::Identity();
}

Matrix2d slope_map(const std::string& model, const Matrix2d& V, double phi) {
  const Vector2d direction(std::cos(phi), std::sin(phi));
  const double radial = direction.dot(V * direction);
  if (model == "power_matrix") return V;
  if (model == "thin_lens") return 0.5 * V.trace() * Matrix2d::Identity();
  if (model == "pinhole") return Matrix2d::Zero();
  return radial * Matrix2d::Identity();
}

double psf_pixel_rad(const PsfSetup& setup) {
  const Ellipse e = Ellipse::image_of_disc(needed_vergence(setup.rx, setup.distance_m), 0.5e-3 * setup.pupil_mm);
  return 3.2 * e.semi_major / psf_resolution;
}

}  // namespace sturm::test
