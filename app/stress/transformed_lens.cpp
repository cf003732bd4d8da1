#include "app/stress/transformed_lens.h"

#include <cmath>

#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

/// TABO meridian of a torus's sweep.
double meridian_deg(const TorusSurface& torus) {
  return 180.0 - std::atan2(torus.sweep_direction().y(), torus.sweep_direction().x()) / radians_per_degree;
}

template <class Change>
Spectacles with_tori(Spectacles lens, Change change) {
  for (Surface* surface : {&lens.back, &lens.front})
    if (const auto* torus = std::get_if<TorusSurface>(surface))
      *surface = TorusSurface(torus->sweep_curvature(), torus->generator_curvature(), change(meridian_deg(*torus)));
  return lens;
}

Surface scaled(const Surface& surface, double k) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface))
    return TorusSurface(torus->sweep_curvature() / k, torus->generator_curvature() / k, meridian_deg(*torus));
  if (const auto* conic = std::get_if<ConicSurface>(&surface)) return ConicSurface{conic->curvature / k, conic->conic_constant};
  return SphereSurface{std::get<SphereSurface>(surface).curvature / k};
}

}  // namespace

Spectacles turned(const Spectacles& lens, double angle_deg) {
  return with_tori(lens, [&](double meridian) { return meridian - angle_deg; });  // the examiner sees it turn the other way
}

Spectacles mirrored(const Spectacles& lens) {
  return with_tori(lens, [](double meridian) { return 180.0 - meridian; });
}

Spectacles scaled(const Spectacles& lens, double k) {
  Spectacles s = lens;
  s.back = scaled(lens.back, k);
  s.front = scaled(lens.front, k);
  s.center_thickness_m *= k;
  s.vertex_distance_m *= k;
  s.diameter_m *= k;
  return s;
}

}  // namespace sturm::stress
