#pragma once
#include <algorithm>
#include <cstddef>

namespace sturm {

/// A picture cut into squares, row by row; those at the right and lower edge may be smaller.
struct TileGrid {
  struct Tile {
    int x0, y0, x1, y1;  ///< pixels x0 ≤ x < x1, y0 ≤ y < y1

    int pixels() const { return (x1 - x0) * (y1 - y0); }
  };

  int width, height, size;

  int across() const { return (width + size - 1) / size; }
  std::size_t count() const {
    return static_cast<std::size_t>(across()) * static_cast<std::size_t>((height + size - 1) / size);
  }
  Tile at(std::size_t index) const {
    const int column = static_cast<int>(index) % across(), row = static_cast<int>(index) / across();
    return {column * size, row * size, std::min(width, (column + 1) * size), std::min(height, (row + 1) * size)};
  }
};

}  // namespace sturm
