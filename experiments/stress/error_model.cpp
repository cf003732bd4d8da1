#include "experiments/stress/error_model.h"

#include <algorithm>
#include <cmath>

namespace sturm::stress {

namespace {

constexpr double eta = formula_error;

/// What rounding does to height, slope and Hessian of a surface at one place.
struct SurfaceErrors {
  double inclination = 1.0;  ///< √(1 + |∇z|²)
  double value = 0.0;        ///< [m]
  double gradient = 0.0;
  double hessian = 0.0;  ///< [1/m]
};

/// The radicands p², q² lose their digits where the surface turns vertical: relative error eta · (size of their
/// terms)/(their value).
double loss_of_radicands(const Surface& surface, double x, double y) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface)) {
    const double cs = torus->sweep_curvature(), cg = torus->generator_curvature();
    const double s = torus->sweep_direction().x() * x + torus->sweep_direction().y() * y;
    const double g = torus->sweep_direction().x() * y - torus->sweep_direction().y() * x;
    const double p2 = 1.0 - cg * cg * g * g, z0 = cg * g * g / (1.0 + std::sqrt(std::max(0.0, p2))), m = 1.0 - cs * z0;
    const double q2 = m * m - cs * cs * s * s;
    return (1.0 + cg * cg * g * g) / p2 * ((1.0 + std::abs(cs * z0)) * (1.0 + std::abs(cs * z0)) + cs * cs * s * s) /
           q2;
  }
  const auto* conic = std::get_if<ConicSurface>(&surface);
  const double c = conic ? conic->curvature : std::get<SphereSurface>(surface).curvature,
               k1 = conic ? 1.0 + conic->conic_constant : 1.0;
  const double term = k1 * c * c * (x * x + y * y);
  return (1.0 + std::abs(term)) / (1.0 - term);
}

/// A spline is a sum of the cell's 16 coefficients, as large as C, with basis polynomials whose absolute values sum to
/// 1; those of the first derivative to at most 3/2, of the second to 4, by the knot's number. The number itself, (x −
/// first)/h, is rounded: as if the point stood aside.
SurfaceErrors errors_of(const BSplineSurface& spline, const Crossing& at) {
  const KnotGrid& grid = spline.grid();
  const auto cell = [](double x, int cells) { return std::clamp(static_cast<int>(x), 0, cells - 1); };
  const double c = spline.coefficients()
                       .block<4, 4>(cell((at.x - grid.first.x()) / grid.spacing.x(), grid.cells_x),
                                    cell((at.y - grid.first.y()) / grid.spacing.y(), grid.cells_y))
                       .cwiseAbs()
                       .maxCoeff();
  const double hx = grid.spacing.x(), hy = grid.spacing.y(), aside = eta * (std::hypot(at.x, at.y) + grid.first.norm());
  const double first = 1.5 * std::hypot(1.0 / hx, 1.0 / hy), mixed = 2.25 / (hx * hy),
               second = std::sqrt(16.0 / (hx * hx * hx * hx) + 16.0 / (hy * hy * hy * hy) + 2.0 * mixed * mixed);
  SurfaceErrors e;
  e.value = eta * c + at.shape.gradient * aside;
  e.gradient = eta * c * first + at.shape.hessian * aside;
  e.hessian = eta * c * second + at.shape.hessian_change * aside;
  return e;
}

SurfaceErrors errors_of(const Surface& surface, const Crossing& at) {
  if (!at.on_sheet) return {};
  SurfaceErrors e;
  if (const auto* spline = std::get_if<BSplineSurface>(&surface)) {
    e = errors_of(*spline, at);
  } else {
    const double relative = eta * std::max(1.0, loss_of_radicands(surface, at.x, at.y));
    e.value = relative * (std::abs(at.z) + at.shape.gradient * std::hypot(at.x, at.y));
    e.gradient = relative * at.shape.gradient;
    e.hessian = relative * at.shape.hessian;
  }
  e.inclination = std::sqrt(1.0 + at.shape.gradient * at.shape.gradient);
  return e;
}

/// Errors of one pair of blocks, as they run along.
struct Blocks {
  double offset = 0.0, slope = 0.0;
};

/// What is off at one surface: lengths, cosines and frames by parts (`relative`), the bend γK.
struct PassErrors {
  double length, relative, gamma_error, curvature_error;
  double gamma, curvature;  ///< sizes
};

/// Transfer A + LB, then refraction A' = C'C⁻¹A, B' = C'⁻¹(μCB − γ K C⁻¹A), each rounded.
void pass(Blocks& e, const Crossing& at, const PassErrors& by, double offset_in, double slope_in, double offset_out) {
  const double c = at.cos_in, c_out = at.cos_out;
  const double stretch = std::max(1.0, c_out / c), squeeze = at.mu * std::max(1.0, c / c_out),
               bend = by.gamma * by.curvature / (c * c_out);
  const double offset_error =
      e.offset + at.path_m * e.slope + slope_in * by.length + eta * (offset_in + at.path_m * slope_in);
  e.slope = squeeze * e.slope + bend * offset_error + (squeeze * slope_in + bend * offset_in) * by.relative +
            offset_in * (by.gamma_error * by.curvature + by.gamma * by.curvature_error) / (c * c_out);
  e.offset = stretch * offset_error + (stretch * offset_in + offset_out) * by.relative;
}

/// Blocks in the last frame, which turns with the direction by up to tan(θ/2) of its error `direction`.
void bound_exit_frame(const ExtendedTrace& trace, double direction, const Blocks& p, const Blocks& q,
                      ErrorBounds& bounds) {
  const double to_z = static_cast<double>(trace.direction.z),
               turn = direction * std::sqrt((1.0 + to_z) / (1.0 - to_z)) + eta * 2.0 / (1.0 - to_z);
  const Crossing& last = trace.at[1];
  bounds.offset_p = p.offset + last.offset_p_out * turn;
  bounds.offset_q = q.offset + last.offset_q_out * turn;
  bounds.slope_p = p.slope + last.slope_p_out * turn;
  bounds.slope_q = q.slope + last.slope_q_out * turn;
}

}  // namespace

ErrorBounds error_bounds(const Spectacles& lens, double rotation_center_m, const ExtendedTrace& trace) {
  ErrorBounds bounds;
  // A turn of the frame (mounting, wedge) is a product with rounded cosines: eta of the length of what is turned.
  const Mounting& mounting = lens.mounting;
  const double turned = mounting.straight() ? 0.0 : eta, wedged = mounting.has_wedge() ? eta : 0.0;
  const double reach = rotation_center_m + lens.vertex_distance_m + mounting.decentration_m().norm();
  double point = (eta + turned) * reach, direction = eta + turned;  // of the ray
  double hit_before = point;
  Blocks p{eta, 0.0}, q{0.0, eta};
  for (int i = 0; i < trace.crossings; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Crossing& at = trace.at[k];
    const SurfaceErrors s = errors_of(i == 0 ? lens.back : lens.front, at);
    const SurfaceShape& shape = at.shape;
    // Into the back's own frame and out of it again, and out of the lens's.
    const double frames = 2.0 * (i == 0 ? wedged : 0.0) + turned;
    const double c = at.cos_in, sine = std::sqrt(std::max(0.0, 1.0 - c * c)),
                 length = at.path_m + std::hypot(at.x, at.y) + lens.diameter_m;
    // Where it meets the surface: the ray stands aside, the height is rounded, the search stops within 2 eta of its
    // bracket.
    const double aside = point + at.path_m * direction + 2.0 * eta * length +
                         frames * (at.path_m + reach + std::hypot(at.x, at.y, at.z));
    const double hit = (aside + s.value / s.inclination) / c;
    const double gradient = shape.hessian * hit + s.gradient, normal = gradient / s.inclination + eta + frames;
    const double tilt = direction + normal, cos_in = sine * tilt + tilt * tilt + eta;
    bounds.hit[k] = hit;
    bounds.cos_in[k] = cos_in;
    bounds.radicand[k] = 2.0 * at.mu * at.mu * c * cos_in + eta * (1.0 + at.mu * at.mu);
    if (!(at.radicand > 0.0)) return bounds;
    const double c_out = at.cos_out, cos_out = 0.5 * bounds.radicand[k] / c_out + eta;
    const double gamma = std::abs(c_out - at.mu * c),
                 gamma_error = cos_out + at.mu * cos_in + eta * (c_out + at.mu * c);
    const double bent = at.mu * direction + gamma * normal + gamma_error + eta * (1.0 + at.mu);

    // A turn of (u, v) by tilt/sin cancels but for 1/(cc') − 1.
    const double length_error = hit + hit_before + eta * length;
    const double turn = sine > 0.0 ? tilt * (1.0 / (c * c_out) - 1.0) / sine + tilt * sine : 0.0;
    const double relative = cos_in / c + cos_out / c_out + turn + eta;
    const double curvature = shape.hessian / s.inclination;
    const double curvature_error =
        (shape.hessian * (2.0 * normal + shape.gradient * gradient / (s.inclination * s.inclination) + 2.0 * frames) +
         s.hessian + shape.hessian_change * hit) /
        s.inclination;
    const PassErrors by{length_error, relative, gamma_error, curvature_error, gamma, curvature};
    pass(p, at, by, at.offset_p_in, at.slope_p_in, at.offset_p_out);
    pass(q, at, by, at.offset_q_in, at.slope_q_in, at.offset_q_out);
    point = hit;
    hit_before = hit;
    direction = bent;
  }
  if (trace.status != LensStatus::ok) return bounds;
  bounds.exit_point = point + eta * lens.diameter_m;
  bounds.direction = direction + turned;
  bound_exit_frame(trace, direction, p, q, bounds);
  return bounds;
}

BlockBounds split_bounds(const ExtendedTrace& trace) {
  Blocks p{eta, 0.0}, q{0.0, eta};
  for (const Crossing& at : trace.at) {
    const double gamma = std::abs(at.cos_out - at.mu * at.cos_in);
    const double curvature = at.shape.hessian / std::sqrt(1.0 + at.shape.gradient * at.shape.gradient);
    const PassErrors by{0.0, eta, eta * gamma, eta * curvature, gamma, curvature};
    pass(p, at, by, at.offset_p_in, at.slope_p_in, at.offset_p_out);
    pass(q, at, by, at.offset_q_in, at.slope_q_in, at.offset_q_out);
  }
  const Crossing& last = trace.at[1];
  return {p.offset + eta * last.offset_p_out, q.offset + eta * last.offset_q_out, p.slope + eta * last.slope_p_out,
          q.slope + eta * last.slope_q_out};
}

}  // namespace sturm::stress
