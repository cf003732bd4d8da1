#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace sturm {

/// One channel of a picture by itself, row 0 at the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;  ///< height × width

  Plane() = default;
  Plane(int width_, int height_) : width(width_), height(height_), values(static_cast<std::size_t>(width_) * height_) {}
};

/// Correlation with `along_x`, or `along_y` (an odd number of weights each, the middle one at the pixel); pixels beyond
/// the border repeat it. Cost: one multiplication per weight and pixel. The same bits for any number of threads.
Plane filtered_along_x(const Plane& plane, std::span<const float> along_x);
Plane filtered_along_y(const Plane& plane, std::span<const float> along_y);

}  // namespace sturm
