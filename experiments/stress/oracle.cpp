#include "experiments/stress/oracle.h"

#include <algorithm>
#include <limits>

#include "experiments/stress/implicit_surface.h"
#include "experiments/stress/placement.h"

namespace sturm::stress {

namespace {

/// A ray with its derivatives.
struct DualRay {
  Vec3<Dual> origin, direction;
};

struct PlainRay {
  Vec3<Extended> origin, direction;
  Vec3<Extended> at(Extended t) const { return origin + t * direction; }
};

PlainRay plain(const DualRay& ray) {
  return {value_of(ray.origin), value_of(ray.direction)};
}

/// The ray of the pupil point p with the slope s, both 0 but with derivatives.
DualRay launched(const Vec3<Extended>& gaze, double rotation_center_m) {
  const Frame f = frame_across(gaze);
  const Dual px(0.0L, 0), py(0.0L, 1), sx(0.0L, 2), sy(0.0L, 3);
  const auto lifted = [](const Vec3<Extended>& v) { return Vec3<Dual>{v.x, v.y, v.z}; };
  const Extended c = rotation_center_m;
  const Vec3<Dual> center = lifted({c * gaze.x, c * gaze.y, c * (gaze.z + 1.0L)});
  return {center + px * lifted(f.e1) + py * lifted(f.e2),
          normalized(lifted(gaze) + sx * lifted(f.e1) + sy * lifted(f.e2))};
}

/// Newton's iteration along the ray; none unless its last step is below 2^-58 of the way and the coordinates (64 bits
/// less what evaluation loses).
std::optional<Extended> converged(const Surface& surface, const PlainRay& ray, Extended t) {
  const Extended enough = std::ldexp(1.0L, -58), size = std::sqrt(dot(ray.origin, ray.origin));
  for (int i = 0; i < 60; ++i) {
    const auto g = implicit(surface, ray.at(t));
    const Extended step = -g.value / dot(g.gradient, ray.direction);
    if (!std::isfinite(step)) return std::nullopt;
    t += step;
    if (std::abs(step) <= enough * (std::abs(t) + size)) return t;
  }
  return std::nullopt;
}

/// The first outward crossing within the rim, searched in 256 steps, so two crossings closer than that stay unseen.
std::optional<Extended> searched(const Surface& surface, const PlainRay& ray, Extended rim) {
  // Within the rim |z| is bounded by the rim's diameter, or the ray leaves the rim before.
  const Extended reach =
      4.0L * rim + std::abs(ray.origin.z) + std::sqrt(ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y);
  constexpr int steps = 256;
  const auto outward = [&](Extended t) -> std::optional<Extended> {
    const auto g = implicit(surface, ray.at(t));
    return g.on_sheet ? std::optional(g.value) : std::nullopt;
  };
  const auto bisected = [](Extended low, Extended high, auto is_low) {
    for (int k = 0; k < 64; ++k) {
      const Extended middle = 0.5L * (low + high);
      (is_low(middle) ? low : high) = middle;
    }
    return low;
  };
  std::optional<Extended> before;
  Extended t_before = 0.0L;
  for (int i = 0; i <= steps; ++i) {
    const Extended next = reach * i / steps;
    const std::optional<Extended> now = outward(next);
    // Where the sheet ends between two steps, look at its last point.
    const Extended t =
        before && !now ? bisected(t_before, next, [&](Extended at) { return outward(at).has_value(); }) : next;
    const std::optional<Extended> there = now ? now : outward(t);
    if (before && there && *before <= 0.0L && *there > 0.0L) {
      const auto crossing = converged(
          surface, ray, bisected(t_before, t, [&](Extended at) { return outward(at).value_or(0.0L) <= 0.0L; }));
      if (!crossing) return std::nullopt;
      const Vec3<Extended> p = ray.at(*crossing);
      if (std::sqrt(p.x * p.x + p.y * p.y) <= rim) return crossing;
    }
    before = now;
    t_before = next;
  }
  return std::nullopt;
}

/// Norm of the part of two derivatives that lies across the ray.
double across(const Vec3<Dual>& v, const Vec3<Extended>& direction, std::size_t first) {
  Extended sum = 0.0L;
  for (std::size_t i = first; i < first + 2; ++i) {
    const Vec3<Extended> d = derivative(v, i), rest = d - dot(d, direction) * direction;
    sum += dot(rest, rest);
  }
  return static_cast<double>(std::sqrt(sum));
}

/// Through one surface. Changes ray; false where it is lost.
bool pass(ExtendedTrace& trace, DualRay& ray, const Surface& surface, const Placement& place, double rim,
          double index_before, double index_behind, const std::optional<Eigen::Vector3d>& start) {
  const DualRay local{place.point_on_surface(ray.origin), place.direction_on_surface(ray.direction)};
  const PlainRay chief = plain(local);
  std::optional<Extended> t;
  if (start) {
    const Vec3<Extended> away = place.point_on_surface(extended(*start)) - chief.origin;
    t = converged(surface, chief, dot(away, chief.direction));
    if (!t) trace.status = LensStatus::no_convergence;
  } else {
    t = searched(surface, chief, rim);
  }
  if (!t) return false;
  // One more step with derivatives: t(p) = t − G(t, p)/G'(t), the theorem of implicit functions.
  const auto g0 = implicit(surface, chief.at(*t));
  const Dual residual = implicit(surface, local.origin + Dual(*t) * local.direction).value;
  const Dual way = Dual(*t) - residual * Dual(1.0L / dot(g0.gradient, chief.direction));
  const Vec3<Dual> point = local.origin + way * local.direction;
  const auto g = implicit(surface, point);
  const Vec3<Dual> normal = normalized(g.gradient);

  Crossing& c = trace.at[static_cast<std::size_t>(trace.crossings++)];
  const Dual mu(static_cast<Extended>(index_before) / static_cast<Extended>(index_behind)),
      cosine = dot(local.direction, normal);
  const Dual radicand = Dual(1.0L) - mu * mu * (Dual(1.0L) - cosine * cosine);
  c.path_m = static_cast<double>(*t);
  c.x = static_cast<double>(point.x.value);
  c.y = static_cast<double>(point.y.value);
  c.z = static_cast<double>(point.z.value);
  c.on_sheet = g.on_sheet;
  if (g.on_sheet) c.shape = shape_at(surface, value_of(point));
  c.mu = static_cast<double>(mu.value);
  c.cos_in = static_cast<double>(cosine.value);
  c.radicand = static_cast<double>(radicand.value);
  const Vec3<Extended> in = chief.direction;
  c.offset_p_in = across(point, in, 0), c.offset_q_in = across(point, in, 2);
  c.slope_p_in = across(local.direction, in, 0), c.slope_q_in = across(local.direction, in, 2);
  if (!(c.path_m > 0.0 && c.cos_in > 0.0) || !g.on_sheet) return false;
  if (!(radicand.value > 0.0L)) {
    trace.status = LensStatus::total_internal_reflection;
    return false;
  }
  const Dual cos_out = sqrt(radicand);
  c.cos_out = static_cast<double>(cos_out.value);
  const Vec3<Dual> bent = normalized(mu * local.direction + (cos_out - mu * cosine) * normal);
  const Vec3<Extended> out = value_of(bent);
  c.offset_p_out = across(point, out, 0), c.offset_q_out = across(point, out, 2);
  c.slope_p_out = across(bent, out, 0), c.slope_q_out = across(bent, out, 2);
  ray = {place.point_before_eye(point), place.direction_before_eye(bent)};
  return true;
}

}  // namespace

ExtendedTrace trace_extended(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m,
                             const std::optional<StartingPoints>& start) {
  ExtendedTrace trace;
  DualRay ray = launched(normalized(extended(gaze)), rotation_center_m);
  const double rim = 0.5 * lens.diameter_m, n = lens.refractive_index;
  const auto back = start ? std::optional(start->back) : std::nullopt,
             front = start ? std::optional(start->front) : std::nullopt;
  if (!pass(trace, ray, lens.back, Placement(lens, Placement::Side::back), rim, 1.0, n, back)) return trace;
  if (!pass(trace, ray, lens.front, Placement(lens, Placement::Side::front), rim, n, 1.0, front)) return trace;
  trace.status = LensStatus::ok;
  trace.exit_point = value_of(ray.origin);
  trace.direction = value_of(ray.direction);
  trace.frame = frame_across(trace.direction);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<Extended> p = derivative(ray.origin, i), s = derivative(ray.direction, i);
    trace.offset[0][i] = dot(p, trace.frame.e1), trace.offset[1][i] = dot(p, trace.frame.e2);
    trace.slope[0][i] = dot(s, trace.frame.e1), trace.slope[1][i] = dot(s, trace.frame.e2);
  }
  return trace;
}

namespace {

/// Of a bundle whose slopes at the pupil are S p.
ExtendedMatrix for_slopes(const std::array<std::array<Extended, 4>, 2>& m, const Eigen::Matrix2d& s) {
  ExtendedMatrix r;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      r[i][j] = m[i][j] + m[i][2] * static_cast<Extended>(s(0, column)) + m[i][3] * static_cast<Extended>(s(1, column));
    }
  return r;
}

}  // namespace

ExtendedMatrix ExtendedTrace::angular_footprint(const Eigen::Matrix2d& slopes, double vergence_D) const {
  const ExtendedMatrix a = for_slopes(offset, slopes), b = for_slopes(slope, slopes);
  ExtendedMatrix r;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) r[i][j] = static_cast<Extended>(vergence_D) * a[i][j] + b[i][j];
  return r;
}

std::optional<ExtendedMatrix> ExtendedTrace::exit_curvature(const Eigen::Matrix2d& slopes) const {
  const ExtendedMatrix a = for_slopes(offset, slopes), b = for_slopes(slope, slopes);
  const Extended det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
  if (det == 0.0L) return std::nullopt;
  const auto row = [&](std::size_t i) {
    return std::array<Extended, 2>{-(b[i][0] * a[1][1] - b[i][1] * a[1][0]) / det,
                                   -(b[i][1] * a[0][0] - b[i][0] * a[0][1]) / det};
  };
  return ExtendedMatrix{row(0), row(1)};
}

}  // namespace sturm::stress
