#include "experiments/stress/transformed_lens.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

/// TABO meridian of a torus's sweep.
double meridian_deg(const TorusSurface& torus) {
  return 180.0 - std::atan2(torus.sweep_direction().y(), torus.sweep_direction().x()) / radians_per_degree;
}

Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle_deg) {
  const auto [sine, cosine] = sine_cosine_of_degrees(angle_deg);
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

/// By a quarter: z'(x, y) = z(y, −x).
BSplineSurface quarter_turned(const BSplineSurface& spline) {
  const KnotGrid& g = spline.grid();
  return {{{-g.last().y(), g.first.x()}, {g.spacing.y(), g.spacing.x()}, g.cells_y, g.cells_x},
          spline.coefficients().rowwise().reverse().transpose()};
}

Surface turned(const Surface& surface, double angle_deg) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface))  // the examiner sees it turn the other way
    return TorusSurface(torus->sweep_curvature(), torus->generator_curvature(), meridian_deg(*torus) - angle_deg);
  if (const auto* spline = std::get_if<BSplineSurface>(&surface)) {
    BSplineSurface result = *spline;
    const int quarters = static_cast<int>(std::lround(angle_deg / 90.0));
    for (int i = 0; i < (quarters % 4 + 4) % 4; ++i) result = quarter_turned(result);
    return result;
  }
  return surface;
}

Surface mirrored(const Surface& surface) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface))
    return TorusSurface(torus->sweep_curvature(), torus->generator_curvature(), 180.0 - meridian_deg(*torus));
  if (const auto* spline = std::get_if<BSplineSurface>(&surface)) {
    const KnotGrid& g = spline->grid();
    return BSplineSurface({{-g.last().x(), g.first.y()}, g.spacing, g.cells_x, g.cells_y},
                          spline->coefficients().colwise().reverse());
  }
  return surface;
}

Surface scaled(const Surface& surface, double k) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface))
    return TorusSurface(torus->sweep_curvature() / k, torus->generator_curvature() / k, meridian_deg(*torus));
  if (const auto* conic = std::get_if<ConicSurface>(&surface))
    return ConicSurface{conic->curvature / k, conic->conic_constant};
  if (const auto* spline = std::get_if<BSplineSurface>(&surface)) {
    const KnotGrid& g = spline->grid();
    return BSplineSurface({k * g.first, k * g.spacing, g.cells_x, g.cells_y}, k * spline->coefficients());
  }
  return SphereSurface{std::get<SphereSurface>(surface).curvature / k};
}

bool is_turned(const Mounting& m) {
  return m.pantoscopic_tilt() != 0.0 || m.wrap() != 0.0;
}

}  // namespace

double possible_turn_deg(const Spectacles& lens, double angle_deg) {
  const bool spline =
      std::holds_alternative<BSplineSurface>(lens.back) || std::holds_alternative<BSplineSurface>(lens.front);
  if (!spline) return angle_deg;
  if (is_turned(lens.mounting)) return 180.0;
  return angle_deg < -90.0 ? 180.0 : std::copysign(90.0, angle_deg);
}

Spectacles turned(const Spectacles& lens, double angle_deg) {
  const Mounting& m = lens.mounting;
  double tilt = 0.0, wrap = 0.0, own_deg = angle_deg;
  if (is_turned(m)) {
    // The lens's axis goes to where the turn takes it; tilt and wrap are read off there, and what is left is a turn
    // about that axis.
    const Eigen::Vector3d axis = m.wearer_from_lens().col(2);
    const Eigen::Vector2d aside = turned(Eigen::Vector2d(axis.head<2>()), angle_deg);
    tilt = std::atan2(aside.y(), std::hypot(aside.x(), axis.z()));
    wrap = std::atan2(-aside.x(), axis.z());
    const Mounting leaning(Eigen::Vector2d::Zero(), tilt, wrap);
    Eigen::Vector3d x = m.wearer_from_lens().col(0);
    x.head<2>() = turned(Eigen::Vector2d(x.head<2>()), angle_deg);
    const Eigen::Vector3d own = leaning.wearer_from_lens().transpose() * x;
    own_deg = std::atan2(own.y(), own.x()) / radians_per_degree;
  }
  Spectacles result = lens;
  result.back = turned(lens.back, own_deg);
  result.front = turned(lens.front, own_deg);
  result.mounting = Mounting(turned(m.decentration_m(), angle_deg), tilt, wrap).with_wedge(turned(m.wedge(), own_deg));
  return result;
}

Spectacles mirrored(const Spectacles& lens) {
  const Eigen::Vector2d flip(-1.0, 1.0);
  const Mounting& m = lens.mounting;
  Spectacles result = lens;
  result.back = mirrored(lens.back);
  result.front = mirrored(lens.front);
  result.mounting = Mounting(flip.cwiseProduct(m.decentration_m()), m.pantoscopic_tilt(), -m.wrap())
                        .with_wedge(flip.cwiseProduct(m.wedge()));
  return result;
}

Spectacles scaled(const Spectacles& lens, double k) {
  const Mounting& m = lens.mounting;
  Spectacles s = lens;
  s.back = scaled(lens.back, k);
  s.front = scaled(lens.front, k);
  s.center_thickness_m *= k;
  s.vertex_distance_m *= k;
  s.diameter_m *= k;
  s.mounting = Mounting(k * m.decentration_m(), m.pantoscopic_tilt(), m.wrap()).with_wedge(m.wedge());
  return s;
}

}  // namespace sturm::stress
