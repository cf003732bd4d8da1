#include "pathtrace/scene/gltf/triangles.h"

#include <cstddef>

namespace sturm::gltf {

std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& v, TriangleMode mode) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (v.size() < 3) return triangles;
  if (mode == TriangleMode::list) {
    triangles.reserve(v.size() / 3);
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) triangles.push_back({v[i], v[i + 1], v[i + 2]});
  } else {
    triangles.reserve(v.size() - 2);
    for (std::size_t i = 0; i + 2 < v.size(); ++i)
      triangles.push_back(mode == TriangleMode::fan ? std::array{v[i + 1], v[i + 2], v[0]}
                                                    : std::array{v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
  }
  return triangles;
}

std::vector<std::uint32_t> used_vertices(std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t count) {
  constexpr std::uint32_t unused = ~0u;
  std::vector<std::uint32_t> place(count, unused), used;
  for (const auto& triangle : triangles)
    for (const std::uint32_t v : triangle) place[v] = 0;
  for (std::size_t v = 0; v < count; ++v)
    if (place[v] != unused) {
      place[v] = static_cast<std::uint32_t>(used.size());
      used.push_back(static_cast<std::uint32_t>(v));
    }
  for (auto& triangle : triangles)
    for (std::uint32_t& v : triangle) v = place[v];
  return used;
}

}  // namespace sturm::gltf
