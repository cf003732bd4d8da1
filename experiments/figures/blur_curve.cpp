#include "experiments/figures/blur_curve.h"

#include <limits>

#include "experiments/figures/conoid_ellipses.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr int steps = 240;

double distance_of(double vergence_D) {
  return vergence_D > 0.0 ? 1.0 / vergence_D : std::numeric_limits<double>::infinity();
}

BlurAtDistance blur_at(const WornEye& worn, double distance_m) {
  return conoid_ellipses(worn, {{0.0, 0.0, distance_m}}).front();
}

bool is_clear(const BlurAtDistance& target, double limit_arcmin) {
  return target.semi_major_arcmin && *target.semi_major_arcmin <= limit_arcmin;
}

/// The vergence between one that is clear and one that is not, at which vision stops being clear.
double border(const WornEye& worn, double clear_D, double blurred_D, double limit_arcmin) {
  constexpr double precision_D = 1e-7;
  while (std::abs(clear_D - blurred_D) > precision_D) {
    const double middle = 0.5 * (clear_D + blurred_D);
    (is_clear(blur_at(worn, distance_of(middle)), limit_arcmin) ? clear_D : blurred_D) = middle;
  }
  return clear_D;
}

/// Where vision that is clear at the nearest target stops being so still nearer; 0 where it does not.
double near_end(const WornEye& worn, double nearest_m, double limit_arcmin) {
  constexpr double nearest_of_all_m = 1e-3;
  double clear_D = vergence_of(nearest_m);
  while (clear_D < 1.0 / nearest_of_all_m) {
    const double nearer_D = 2.0 * clear_D;
    if (!is_clear(blur_at(worn, distance_of(nearer_D)), limit_arcmin))
      return distance_of(border(worn, clear_D, nearer_D, limit_arcmin));
    clear_D = nearer_D;
  }
  return 0.0;
}

std::vector<ClearInterval> clear_intervals(const WornEye& worn, const BlurCurve& curve) {
  std::vector<ClearInterval> intervals;
  double far_D = 0.0;
  bool inside = false;
  for (std::size_t i = 0; i < curve.targets.size(); ++i) {
    const bool clear = is_clear(curve.targets[i], curve.clear_arcmin);
    const double here = vergence_of(curve.targets[i].distance_m);
    if (clear && !inside)
      far_D = i == 0 ? here : border(worn, here, vergence_of(curve.targets[i - 1].distance_m), curve.clear_arcmin);
    if (!clear && inside)
      intervals.push_back(
          {distance_of(border(worn, vergence_of(curve.targets[i - 1].distance_m), here, curve.clear_arcmin)),
           distance_of(far_D)});
    inside = clear;
  }
  if (inside)
    intervals.push_back({near_end(worn, curve.targets.back().distance_m, curve.clear_arcmin), distance_of(far_D)});
  return intervals;
}

}  // namespace

double clear_semi_axis_arcmin(const Eye& eye, double clear_D) {
  return clear_D * eye.pupil_radius_m * arcminutes_per_radian;
}

BlurCurve blur_curve(const WornEye& worn, const std::string& name, double nearest_m, double clear_D) {
  std::vector<Target> targets;
  for (int i = 0; i <= steps; ++i)
    targets.push_back({0.0, 0.0, i == steps ? nearest_m : distance_of(i / (steps * nearest_m))});
  BlurCurve curve{name, conoid_ellipses(worn, targets), clear_semi_axis_arcmin(worn.eye, clear_D), {}};
  curve.clear = clear_intervals(worn, curve);
  return curve;
}

}  // namespace sturm
