#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include "experiments/stress/extended.h"
#include "lensmodel/surface.h"

namespace sturm::stress {

/// A surface as the zero set of a function G with G ≈ −2z at the vertex: another description than the heights z(x, y)
/// that the program works with. `gradient` points outward on the sheet through the vertex.
template <class T>
struct Implicit {
  T value;
  Vec3<T> gradient;
  bool on_sheet;  ///< within the part that the heights describe
};

/// Sphere and conic: c (x² + y² + (1 + k) z²) − 2z.
template <class T>
Implicit<T> conic_function(Extended c, Extended one_plus_k, const Vec3<T>& p) {
  const T bend = T(c * one_plus_k) * p.z - T(1.0L);
  return {T(c) * (p.x * p.x + p.y * p.y + T(one_plus_k) * p.z * p.z) - T(2.0L) * p.z,
          {T(2.0L * c) * p.x, T(2.0L * c) * p.y, T(2.0L) * bend},
          value_of(bend) < 0.0L};
}

/// Torus: a point at (s, g, z) came from the height w = (1 − D)/c_s of the generator, D² = (1 − c_s z)² + c_s² s²: the
/// sweep keeps the distance D/c_s from its axis. There c_g (g² + w²) − 2w = 0. Written so that both curvatures may
/// vanish.
template <class T>
Implicit<T> torus_function(const TorusSurface& torus, const Vec3<T>& p) {
  using std::sqrt;
  const Extended cs = torus.sweep_curvature(), cg = torus.generator_curvature(), ax = torus.sweep_direction().x(),
                 ay = torus.sweep_direction().y();
  const T s = T(ax) * p.x + T(ay) * p.y, g = T(ax) * p.y - T(ay) * p.x;
  const T m = T(1.0L) - T(cs) * p.z, distance = sqrt(m * m + T(cs * cs) * s * s);
  const T w = (T(2.0L) * p.z - T(cs) * (p.z * p.z + s * s)) / (T(1.0L) + distance);
  const T by_w = T(2.0L) * (T(cg) * w - T(1.0L)), by_s = by_w * (T(-cs) * s / distance), by_g = T(2.0L * cg) * g,
          by_z = by_w * (m / distance);
  return {T(cg) * (g * g + w * w) - T(2.0L) * w,
          {T(ax) * by_s - T(ay) * by_g, T(ay) * by_s + T(ax) * by_g, by_z},
          value_of(m) > 0.0L && value_of(by_w) < 0.0L};
}

/// Value and derivative (by the knot number) of a uniform cubic spline in a cell, at t of it, by de Boor's triangle.
/// The last step's difference, times the degree over the knots' span, is the derivative.
template <class T>
std::pair<T, T> de_boor(std::array<T, 4> d, const T& t) {
  for (int level = 1; level <= 2; ++level)
    for (int j = 3; j >= level; --j) {
      const auto at = static_cast<std::size_t>(j);
      const T part = (1.0L / static_cast<Extended>(4 - level)) * (t + T(static_cast<Extended>(3 - j)));
      d[at] = d[at - 1] + part * (d[at] - d[at - 1]);
    }
  const T difference = d[3] - d[2];
  return {d[2] + t * difference, T(3.0L) * difference};
}

/// B-spline: 2 (s(x, y) − z), by de Boor's triangle in each direction (the program sums basis polynomials). Beyond the
/// grid the border cells' polynomials go on, off the sheet.
template <class T>
Implicit<T> spline_function(const BSplineSurface& spline, const Vec3<T>& p) {
  const KnotGrid& grid = spline.grid();
  const auto cell = [](Extended at, int cells) { return std::clamp(static_cast<int>(std::floor(at)), 0, cells - 1); };
  const Extended hx = grid.spacing.x(), hy = grid.spacing.y(), to_x = 1.0L / hx, to_y = 1.0L / hy;
  const T u = to_x * (p.x - T(grid.first.x())), v = to_y * (p.y - T(grid.first.y()));
  const Extended at_u = value_of(u), at_v = value_of(v);
  const int i = cell(at_u, grid.cells_x), j = cell(at_v, grid.cells_y);
  const T tu = u - T(static_cast<Extended>(i)), tv = v - T(static_cast<Extended>(j));
  std::array<T, 4> values, slopes;
  for (int k = 0; k < 4; ++k) {
    const auto row = [&](int l) { return T(static_cast<Extended>(spline.coefficients()(i + k, j + l))); };
    const auto [value, slope] = de_boor(std::array<T, 4>{row(0), row(1), row(2), row(3)}, tv);
    values[static_cast<std::size_t>(k)] = value;
    slopes[static_cast<std::size_t>(k)] = slope;
  }
  const auto [height, by_u] = de_boor(values, tu);
  const T by_v = de_boor(slopes, tu).first;
  return {T(2.0L) * (height - p.z),
          {(2.0L * to_x) * by_u, (2.0L * to_y) * by_v, T(-2.0L)},
          at_u >= 0.0L && at_u <= grid.cells_x && at_v >= 0.0L && at_v <= grid.cells_y};
}

template <class T>
Implicit<T> implicit(const Surface& surface, const Vec3<T>& p) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface)) return torus_function(*torus, p);
  if (const auto* spline = std::get_if<BSplineSurface>(&surface)) return spline_function(*spline, p);
  if (const auto* conic = std::get_if<ConicSurface>(&surface))
    return conic_function(conic->curvature, 1.0L + static_cast<Extended>(conic->conic_constant), p);
  return conic_function(std::get<SphereSurface>(surface).curvature, 1.0L, p);
}

}  // namespace sturm::stress
