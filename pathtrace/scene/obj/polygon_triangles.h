#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sturm {

/// Cuts a polygon of at least three corners into triangles of its corners' numbers, with its winding. A convex one
/// becomes a fan about its first corner; of others ears are cut off (Meisters 1975) in the plane of the polygon's mean
/// normal. A polygon that crosses itself or has no area gets a fan where no ear is left.
void add_triangles_of(std::span<const Eigen::Vector3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace sturm
