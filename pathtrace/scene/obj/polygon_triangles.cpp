#include "pathtrace/scene/obj/polygon_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sturm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Twice the signed area of a triangle.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return cross(b - a, c - a);
}

/// Twice the area of the polygon along its mean normal (Newell's: right also where it is not quite flat).
Vector3d area_vector(std::span<const Vector3d> corners) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return sum;
}

bool is_convex(std::span<const Vector3d> corners, const Vector3d& normal) {
  const std::size_t count = corners.size();
  double turned = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d along = corners[(i + 1) % count] - corners[i],
                   next = corners[(i + 2) % count] - corners[(i + 1) % count];
    const double bend = along.cross(next).dot(normal);
    if (bend < 0.0) return false;
    if (count > 4) turned += std::atan2(bend / normal.norm(), along.dot(next));
  }
  return turned < 7.0;  // 2π; a polygon of five or more corners can run round twice
}

/// The corners in the plane of the polygon, seen from the side that sees them counter-clockwise.
std::vector<Vector2d> flattened(std::span<const Vector3d> corners, const Vector3d& normal) {
  const Vector3d unit = normal.normalized(), across = unit.unitOrthogonal(), up = unit.cross(across);
  std::vector<Vector2d> flat;
  for (const Vector3d& corner : corners)
    flat.emplace_back(across.dot(corner - corners[0]), up.dot(corner - corners[0]));
  return flat;
}

bool is_ear(const std::vector<Vector2d>& flat, const std::vector<std::uint32_t>& left, std::size_t at) {
  const std::size_t count = left.size();
  const std::uint32_t before = left[(at + count - 1) % count], tip = left[at], behind = left[(at + 1) % count];
  const Vector2d &a = flat[before], &b = flat[tip], &c = flat[behind];
  if (!(turn(a, b, c) > 0.0)) return false;
  return std::none_of(left.begin(), left.end(), [&](std::uint32_t other) {
    const Vector2d& p = flat[other];
    if (p == a || p == b || p == c) return false;
    return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
  });
}

/// Cuts ears off until three corners are left, or no ear is.
void cut_ears(const std::vector<Vector2d>& flat, std::vector<std::uint32_t>& left,
              std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t at = 0, tried = 0; left.size() > 3 && tried < left.size();) {
    const std::size_t size = left.size();
    if (!is_ear(flat, left, at)) {
      at = (at + 1) % size;
      ++tried;
      continue;
    }
    triangles.push_back({left[(at + size - 1) % size], left[at], left[(at + 1) % size]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    at %= left.size();
    tried = 0;
  }
}

}  // namespace

void add_triangles_of(std::span<const Vector3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const Vector3d normal = corners.size() > 3 ? area_vector(corners) : Vector3d::Zero();
  if (!(normal.norm() > 0.0) || is_convex(corners, normal)) {
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({0, i, i + 1});
    return;
  }
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  cut_ears(flattened(corners, normal), left, triangles);
  for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
}

}  // namespace sturm
