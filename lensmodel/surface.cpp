#include "lensmodel/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lensmodel/bracketed_root.h"

namespace sturm {

namespace {

/// A point exactly on the rim still belongs to the lens.
constexpr double rim_tolerance = 1e-12;

struct Interval {
  double low, high;
};

/// The part t ≥ 0 of the ray within the cylinder of radius `rim_radius` about the axis and between two heights.
std::optional<Interval> inside(const LightRay& ray, double rim_radius, const Interval& heights) {
  Interval in{0.0, std::numeric_limits<double>::infinity()};
  const Eigen::Vector2d o = ray.origin.head<2>(), d = ray.direction.head<2>();
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - rim_radius * rim_radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || (a == 0.0 && c > 0.0)) return std::nullopt;
  if (a > 0.0) {
    const double root = std::sqrt(discriminant);
    in.low = std::max(in.low, (-b - root) / a);
    in.high = (-b + root) / a;
  }
  if (ray.direction.z() != 0.0) {
    const double first = (heights.low - ray.origin.z()) / ray.direction.z(),
                 second = (heights.high - ray.origin.z()) / ray.direction.z();
    in.low = std::max(in.low, std::min(first, second));
    in.high = std::min(in.high, std::max(first, second));
  } else if (!(ray.origin.z() >= heights.low && ray.origin.z() <= heights.high)) {
    return std::nullopt;
  }
  return in.low < in.high ? std::optional(in) : std::nullopt;
}

/// How far the ray is outward of the surface at t: z of the surface minus z of the ray. None where the surface does not
/// reach.
template <class Shape>
std::optional<double> outward_distance(const Shape& shape, const LightRay& ray, double t) {
  const Eigen::Vector3d p = ray.at(t);
  const auto s = shape.slope(p.x(), p.y());
  return s ? std::optional(s->value - p.z()) : std::nullopt;
}

/// A piece of the ray at whose low end it is on the eye's side and at whose high end it is outside: the whole way if
/// its ends will do.
template <class Shape>
std::optional<Interval> bracket(const Shape& shape, const LightRay& ray, const Interval& way) {
  const auto first = outward_distance(shape, ray, way.low), last = outward_distance(shape, ray, way.high);
  if (first && last && *first <= 0.0 && *last >= 0.0) return way;
  return std::nullopt;
}

/// The same among 16 pieces of the way, where the surface ends before the rim does or is interrupted, or the ray
/// crosses it twice.
template <class Shape>
std::optional<Interval> bracket_in_pieces(const Shape& shape, const LightRay& ray, const Interval& way) {
  const auto at = [&](double t) { return outward_distance(shape, ray, t); };
  constexpr int pieces = 16;
  double low = way.low;
  auto below = at(way.low);
  for (int i = 1; i <= pieces; ++i) {
    double high = i == pieces ? way.high : way.low + (way.high - way.low) * i / pieces;
    auto above = at(high);
    const double next_low = high;
    const auto next_below = above;
    if (below && !above) {  // the surface's edge lies in this piece: take the last point before it
      double valid = low, invalid = high;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (valid + invalid);
        (at(middle) ? valid : invalid) = middle;
      }
      above = at(high = valid);
    }
    if (below && above && *below <= 0.0 && *above >= 0.0) return Interval{low, high};
    low = next_low;
    below = next_below;
  }
  return std::nullopt;
}

SurfaceHit hit_at(const LightRay& ray, double t, const std::optional<Sag>& sag, double rim_radius) {
  const Eigen::Vector3d position = ray.at(t);
  if (!sag || !(t > 0.0) || position.head<2>().norm() > rim_radius * (1.0 + rim_tolerance)) return {};
  if (!(outward_normal(*sag).dot(ray.direction) > 0.0)) return {};
  return {LensStatus::ok, t, position, *sag};
}

SurfaceHit intersect_shape(const SphereSurface& sphere, const LightRay& ray, double rim_radius) {
  const auto t = sphere.crossing(ray);
  if (!t) return {};
  const Eigen::Vector3d p = ray.at(*t);
  return hit_at(ray, *t, sphere.sag(p.x(), p.y()), rim_radius);
}

/// No point of the surface within the rim lies outside of these heights.
Interval height_bounds(const SphereSurface& sphere, double r) {
  const auto rim = sphere.sag(r, 0.0);
  const double height =
      rim ? rim->value : std::copysign(r, sphere.curvature);  // a whole hemisphere rises by its radius ≤ r
  return {std::min(0.0, height), std::max(0.0, height)};
}
Interval height_bounds(const ConicSurface& conic, double r) {
  const auto rim = conic.slope(r, 0.0);
  const double height = rim ? rim->value : conic.curvature * r * r;  // (1 + √…) z = c r², wherever it ends
  return {std::min(0.0, height), std::max(0.0, height)};
}
Interval height_bounds(const TorusSurface& torus, double r) {
  // Along the sweep and along the generator the height rises or falls all the way outwards, so a box has its extremes
  // in its corners.
  const Eigen::Vector2d s = r * torus.sweep_direction(), g(-s.y(), s.x());
  Interval bounds{0.0, 0.0};
  for (const Eigen::Vector2d& corner : {s, g, Eigen::Vector2d(s + g)}) {
    const auto there = torus.slope(corner.x(), corner.y());
    if (!there) return {-2.0 * r, 2.0 * r};  // each of the two arcs rises by at most its half chord
    bounds = {std::min(bounds.low, there->value), std::max(bounds.high, there->value)};
  }
  return bounds;
}
Interval height_bounds(const BSplineSurface& spline, double) {
  return {spline.lowest(), spline.highest()};
}

/// The part of a ray where it can meet the surface within the rim. Bounds only: the rim itself is tested in hit_at.
template <class Shape>
std::optional<Interval> reachable(const Shape& shape, const LightRay& ray, double rim_radius) {
  constexpr double slack = 1.0 + 1e-9;
  const Interval bounds = height_bounds(shape, rim_radius);
  const double margin = (bounds.high - bounds.low) * (slack - 1.0) + 1e-6 * rim_radius;
  return inside(ray, rim_radius * slack, {bounds.low - margin, bounds.high + margin});
}

template <class Shape>
SurfaceHit intersect_shape(const Shape& shape, const LightRay& ray, double rim_radius) {
  const auto way = reachable(shape, ray, rim_radius);
  if (!way) return {};
  const auto root = [&](const std::optional<Interval>& piece) -> std::optional<double> {
    if (!piece) return std::nullopt;
    return bracketed_root(
        [&](double at) {
          const Eigen::Vector3d p = ray.at(at);
          const auto s = shape.slope(p.x(), p.y());
          constexpr double nan = std::numeric_limits<double>::quiet_NaN();
          if (!s) return std::pair(nan, nan);
          return std::pair(s->value - p.z(), s->gradient.dot(ray.direction.head<2>()) - ray.direction.z());
        },
        piece->low, piece->high);
  };
  auto t = root(bracket(shape, ray, *way));
  if (!t) {  // also where the ends of the way will do but the surface is interrupted between them
    const auto piece = bracket_in_pieces(shape, ray, *way);
    if (!piece) return {};
    t = root(piece);
  }
  if (!t) return {LensStatus::no_convergence, 0.0, {}, {}};
  const Eigen::Vector3d p = ray.at(*t);
  return hit_at(ray, *t, shape.sag(p.x(), p.y()), rim_radius);
}

}  // namespace

std::optional<Sag> sag(const Surface& surface, double x, double y) {
  return std::visit([&](const auto& shape) { return shape.sag(x, y); }, surface);
}

bool may_meet(const Surface& surface, const LightRay& ray, double rim_radius) {
  return std::visit([&](const auto& shape) { return reachable(shape, ray, rim_radius).has_value(); }, surface);
}

SurfaceHit intersect(const Surface& surface, const LightRay& ray, double rim_radius) {
  return std::visit([&](const auto& shape) { return intersect_shape(shape, ray, rim_radius); }, surface);
}

}  // namespace sturm
