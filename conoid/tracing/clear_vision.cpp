#include "conoid/tracing/clear_vision.h"

#include <cmath>
#include <limits>

namespace sturm {

namespace {

constexpr double exact_D = 1e-10;

/// Where f is least within [low, high], to `exact_D` for a convex f: golden section.
template <class Function>
double least(const Function& f, double low, double high) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double a = high - ratio * (high - low), b = low + ratio * (high - low), fa = f(a), fb = f(b);
  while (high - low > exact_D) {
    if (fa <= fb) {
      high = b;
      b = a;
      fb = fa;
      a = high - ratio * (high - low);
      fa = f(a);
    } else {
      low = a;
      a = b;
      fa = fb;
      b = low + ratio * (high - low);
      fb = f(b);
    }
  }
  return 0.5 * (low + high);
}

/// The last place from `inside` on towards `outside` where `holds` is true, if it holds inside.
template <class Predicate>
double last_place(const Predicate& holds, double inside, double outside) {
  if (holds(outside)) return outside;
  while (std::abs(outside - inside) > exact_D) {
    const double middle = 0.5 * (inside + outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

ClearVision clear_vision(const TurnedEye& eye, double pupil_radius_m, double limit_rad) {
  const auto semi_major = [&](double vergence_D) {
    const double distance_m = vergence_D > 0.0 ? 1.0 / vergence_D : std::numeric_limits<double>::infinity();
    return Ellipse::image_of_disc(eye.footprint(distance_m).angular, pupil_radius_m).semi_major;
  };
  ClearVision result{};
  result.best_vergence_D = least(semi_major, 0.0, nearest_clear_D);
  if (semi_major(0.0) <= semi_major(result.best_vergence_D)) result.best_vergence_D = 0.0;
  result.best_semi_major_rad = semi_major(result.best_vergence_D);
  if (!(result.best_semi_major_rad <= limit_rad)) return result;
  const auto clear = [&](double vergence_D) { return semi_major(vergence_D) <= limit_rad; };
  result.interval = {last_place(clear, result.best_vergence_D, 0.0),
                     last_place(clear, result.best_vergence_D, nearest_clear_D)};
  return result;
}

}  // namespace sturm
