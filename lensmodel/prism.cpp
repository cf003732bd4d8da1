#include "lensmodel/prism.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Slope of the ray along the lens's axis after the lens, in its frame.
Eigen::Vector2d axial_deviation(const Spectacles& lens) {
  const LensPath path = trace(lens, {{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}});
  const Eigen::Vector3d& out = path.exit.direction;
  if (path.status != LensStatus::ok || !(out.z() < 0.0)) throw std::domain_error("a prism that this lens cannot have");
  return out.head<2>() / -out.z();
}

}  // namespace

Spectacles with_prism(const Spectacles& lens, double prism_cm_per_m, double base_deg) {
  const auto [sine, cosine] = sine_cosine_of_degrees(180.0 - base_deg);  // the examiner's x is the wearer's −x
  const Eigen::Vector2d wanted = 0.01 * prism_cm_per_m * Eigen::Vector2d(cosine, sine);
  const double excess = lens.refractive_index - 1.0;

  Spectacles straight = lens;
  straight.mounting = Mounting();
  straight.vertex_distance_m = 1e-3;  // any: a deviation does not depend on it
  Eigen::Vector2d wedge = Eigen::Vector2d::Zero(), best = wedge;
  double least = std::numeric_limits<double>::infinity();  // error, of the best
  // A thin wedge of slope g deviates by (n − 1) g: one step of that is wrong by the thickness times the front's power,
  // a few per cent.
  constexpr int most_steps = 60;
  constexpr double settled = 1e-15;
  for (int i = 0; i < most_steps && least > settled; ++i) {
    straight.mounting = Mounting().with_wedge(wedge);
    const Eigen::Vector2d error = axial_deviation(straight) - wanted;
    if (error.norm() < least) {
      least = error.norm();
      best = wedge;
    }
    if (!(excess > 0.0)) break;
    wedge -= error / excess;
  }
  // Rounding of the two refractions may keep the steps going above `settled` for ever.
  if (!(least <= prism_accuracy)) throw std::domain_error("a prism that this lens cannot have");
  Spectacles result = lens;
  result.mounting = lens.mounting.with_wedge(best);
  return result;
}

}  // namespace sturm
