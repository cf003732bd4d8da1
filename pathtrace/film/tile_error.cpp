#include "pathtrace/film/tile_error.h"

#include <algorithm>

namespace sturm {

namespace {

constexpr double offset = 0.01;  // that of compare/metrics/relative_mse.cpp

double neighbourhood_mean(const std::vector<PixelPair>& pixels, int width, int height, int x, int y,
                          std::size_t channel) {
  double sum = 0.0;
  int count = 0;
  for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u, ++count) {
      const PixelPair& p = pixels[static_cast<std::size_t>(v * width + u)];
      sum += 0.5 * (p.first[channel] + p.second[channel]);
    }
  return sum / count;
}

}  // namespace

double tile_squared_error(const std::vector<PixelPair>& pixels, int width) {
  const int height = static_cast<int>(pixels.size()) / width;
  double sum = 0.0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const PixelPair& p = pixels[static_cast<std::size_t>(y * width + x)];
      for (std::size_t k = 0; k < 3; ++k) {
        const double half_difference = 0.5 * (p.first[k] - p.second[k]),
                     mean = neighbourhood_mean(pixels, width, height, x, y, k);
        sum += half_difference * half_difference / (mean * mean + offset);
      }
    }
  return sum / (3.0 * static_cast<double>(pixels.size()));
}

}  // namespace sturm
