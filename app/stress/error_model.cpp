#include "app/stress/error_model.h"

#include <algorithm>
#include <cmath>

namespace sturm::stress {

namespace {

constexpr double eta = formula_error;

/// What rounding does to height, slope and curvature of a surface at one place.
struct SurfaceErrors {
  double gradient = 0.0, hessian = 0.0, inclination = 1.0;  ///< |∇z|, |∇∇z|, √(1 + |∇z|²)
  double value_error = 0.0;                                 ///< [m]
  double relative_error = 0.0;                              ///< of gradient and Hessian
  double hessian_change = 0.0;                              ///< |d∇∇z| per metre, by differences
};

/// The radicands p², q² lose their digits where the surface turns vertical: relative error eta · (size of their terms)/(their value).
double loss_of_radicands(const Surface& surface, double x, double y) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface)) {
    const double cs = torus->sweep_curvature(), cg = torus->generator_curvature();
    const double s = torus->sweep_direction().x() * x + torus->sweep_direction().y() * y;
    const double g = torus->sweep_direction().x() * y - torus->sweep_direction().y() * x;
    const double p2 = 1.0 - cg * cg * g * g, z0 = cg * g * g / (1.0 + std::sqrt(std::max(0.0, p2))), m = 1.0 - cs * z0;
    const double q2 = m * m - cs * cs * s * s;
    return (1.0 + cg * cg * g * g) / p2 * ((1.0 + std::abs(cs * z0)) * (1.0 + std::abs(cs * z0)) + cs * cs * s * s) / q2;
  }
  const auto* conic = std::get_if<ConicSurface>(&surface);
  const double c = conic ? conic->curvature : std::get<SphereSurface>(surface).curvature, k1 = conic ? 1.0 + conic->conic_constant : 1.0;
  const double term = k1 * c * c * (x * x + y * y);
  return (1.0 + std::abs(term)) / (1.0 - term);
}

SurfaceErrors errors_of(const Surface& surface, double x, double y) {
  SurfaceErrors e;
  const auto here = sag(surface, x, y);
  if (!here) return e;
  e.gradient = here->gradient.norm();
  e.hessian = here->hessian.norm();
  e.inclination = std::sqrt(1.0 + e.gradient * e.gradient);
  const double loss = std::max(1.0, loss_of_radicands(surface, x, y));
  e.value_error = eta * loss * (std::abs(here->value) + e.gradient * std::hypot(x, y));
  e.relative_error = eta * loss;
  const double h = 1e-6 * std::min(1e-2, e.hessian > 0.0 ? 1.0 / e.hessian : 1e-2);
  for (const Eigen::Vector2d& by : {Eigen::Vector2d(h, 0.0), Eigen::Vector2d(0.0, h)}) {
    auto there = sag(surface, x + by.x(), y + by.y());
    if (!there) there = sag(surface, x - by.x(), y - by.y());
    if (there) e.hessian_change = std::max(e.hessian_change, (there->hessian - here->hessian).norm() / h);
  }
  return e;
}

/// Errors of one pair of blocks, as they run along.
struct Blocks {
  double offset = 0.0, slope = 0.0;
};

}  // namespace

ErrorBounds error_bounds(const Spectacles& lens, double rotation_center_m, const ExtendedTrace& trace) {
  ErrorBounds bounds;
  double point = eta * (rotation_center_m + lens.vertex_distance_m), direction = eta;  // of the ray
  double hit_before = point;
  Blocks p{eta, 0.0}, q{0.0, eta};
  for (int i = 0; i < trace.crossings; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Crossing& at = trace.at[k];
    const SurfaceErrors s = errors_of(i == 0 ? lens.back : lens.front, at.x, at.y);
    const double c = at.cos_in, sine = std::sqrt(std::max(0.0, 1.0 - c * c)), length = at.path_m + std::hypot(at.x, at.y) + lens.diameter_m;
    // Where it meets the surface: the ray stands aside, the height is rounded, the search stops within 2 eta of its bracket.
    const double aside = point + at.path_m * direction + 2.0 * eta * length;
    const double hit = (aside + s.value_error / s.inclination) / c;
    const double gradient = s.hessian * hit + s.gradient * s.relative_error, normal = gradient / s.inclination + eta;
    const double tilt = direction + normal, cos_in = sine * tilt + tilt * tilt + eta;
    bounds.hit[k] = hit;
    bounds.cos_in[k] = cos_in;
    bounds.radicand[k] = 2.0 * at.mu * at.mu * c * cos_in + eta * (1.0 + at.mu * at.mu);
    if (!(at.radicand > 0.0)) return bounds;
    const double c_out = at.cos_out, cos_out = 0.5 * bounds.radicand[k] / c_out + eta;
    const double gamma = std::abs(c_out - at.mu * c), gamma_error = cos_out + at.mu * cos_in + eta * (c_out + at.mu * c);
    const double bent = at.mu * direction + gamma * normal + gamma_error + eta * (1.0 + at.mu);

    // Transfer A + LB, then refraction A' = C'C⁻¹A, B' = C'⁻¹(μCB − γ K C⁻¹A). A turn of (u, v) by tilt/sin cancels but for 1/(cc') − 1.
    const double length_error = hit + hit_before + eta * length;
    const double turn = sine > 0.0 ? tilt * (1.0 / (c * c_out) - 1.0) / sine + tilt * sine : 0.0;
    const double relative = cos_in / c + cos_out / c_out + turn + eta;
    const double stretch = std::max(1.0, c_out / c), squeeze = at.mu * std::max(1.0, c / c_out);
    const double curvature = s.hessian / s.inclination;
    const double curvature_error =
        (2.0 * s.hessian * normal + s.hessian * s.gradient * gradient + s.hessian * s.relative_error + s.hessian_change * hit) /
        s.inclination;
    const auto through = [&](Blocks& e, double offset_in, double slope_in, double offset_out) {
      const double offset_error = e.offset + at.path_m * e.slope + slope_in * length_error + eta * (offset_in + at.path_m * slope_in);
      const double bend = offset_in / (c * c_out);
      e.slope = squeeze * e.slope + gamma * curvature * offset_error / (c * c_out) + squeeze * slope_in * relative +
                bend * (gamma * curvature * relative + gamma_error * curvature + gamma * curvature_error);
      e.offset = stretch * offset_error + (stretch * offset_in + offset_out) * relative;
    };
    through(p, at.offset_p_in, at.slope_p_in, at.offset_p_out);
    through(q, at.offset_q_in, at.slope_q_in, at.offset_q_out);
    point = hit;
    hit_before = hit;
    direction = bent;
  }
  if (trace.status != LensStatus::ok) return bounds;
  // The last frame turns with the direction by up to tan(θ/2) of its error.
  const double to_z = static_cast<double>(trace.direction.z),
               turn = direction * std::sqrt((1.0 + to_z) / (1.0 - to_z)) + eta * 2.0 / (1.0 - to_z);
  const Crossing& last = trace.at[1];
  bounds.exit_point = point + eta * lens.diameter_m;
  bounds.direction = direction;
  bounds.offset_p = p.offset + last.offset_p_out * turn;
  bounds.offset_q = q.offset + last.offset_q_out * turn;
  bounds.slope_p = p.slope + last.slope_p_out * turn;
  bounds.slope_q = q.slope + last.slope_q_out * turn;
  return bounds;
}

}  // namespace sturm::stress
