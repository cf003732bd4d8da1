#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace sturm::gltf {

enum class TriangleMode : std::uint64_t { list = 4, strip = 5, fan = 6 };

/// The triangles of a list, strip or fan of vertices [glTF 2.0 specification, section 3.7.2.1]; what is left over at
/// the end makes none.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& vertices, TriangleMode mode);

/// The vertices that triangles have, in ascending order, and renumbers the triangles to places in that list.
std::vector<std::uint32_t> used_vertices(std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t count);

}  // namespace sturm::gltf
