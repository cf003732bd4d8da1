#include "compare/images/noise_floor.h"

#include <algorithm>
#include <cmath>

#include "compare/statistics/statistics.h"

namespace sturm {

namespace {

constexpr int smallest_block_px = 32;
constexpr double largest_z = 37.5;  // as normal_equivalent_of_t

struct Block {
  double excess = 0.0, pixels = 0.0;
};

/// Sum over each block of how much worse the comparison is than the seeds.
std::vector<Block> blocks_of(const ImageMetric& metric, const std::vector<const ImageMetric*>& seeds,
                             const Image* mask) {
  const Image& map = metric.map;
  const int block_px = std::max(smallest_block_px, 2 * metric.window_px);
  const int across = (map.width + block_px - 1) / block_px, down = (map.height + block_px - 1) / block_px;
  std::vector<Block> blocks(static_cast<std::size_t>(across) * down);
  const double sign = metric.map_is_similarity ? -1.0 : 1.0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      if (mask && !(*mask->at(x + metric.margin, y + metric.margin) > 0.0f)) continue;
      double floor = 0.0;
      for (const ImageMetric* seed : seeds) floor += *seed->map.at(x, y) / static_cast<double>(seeds.size());
      Block& b = blocks[static_cast<std::size_t>(y / block_px) * across + x / block_px];
      b.excess += sign * (*map.at(x, y) - floor);
      b.pixels += 1.0;
    }
  std::erase_if(blocks, [](const Block& b) { return b.pixels == 0.0; });
  return blocks;
}

std::optional<double> z_of(const std::vector<Block>& blocks) {
  if (blocks.size() < 2) return std::nullopt;
  double excess = 0.0, pixels = 0.0, squares = 0.0;
  for (const Block& b : blocks) excess += b.excess, pixels += b.pixels;
  const double mean = excess / pixels, n = static_cast<double>(blocks.size());
  for (const Block& b : blocks) squares += (b.excess - mean * b.pixels) * (b.excess - mean * b.pixels);
  const double error = std::sqrt(squares * n / (n - 1.0)) / pixels;
  if (error == 0.0) return mean == 0.0 ? 0.0 : std::copysign(largest_z, mean);
  return normal_equivalent_of_t(mean / error, n - 1.0);
}

}  // namespace

NoiseFloor noise_floor(const ImageMetric& metric, const std::vector<const ImageMetric*>& between_seeds,
                       const Image* mask) {
  NoiseFloor floor;
  for (const ImageMetric* seed : between_seeds) {
    const std::optional<double> value = mask ? seed->within(*mask) : seed->value;
    if (!value) continue;
    const bool worse = !floor.value || (metric.more_is_better ? *value < *floor.value : *value > *floor.value);
    if (worse) floor.value = value;
  }
  const std::optional<double> value = mask ? metric.within(*mask) : metric.value;
  if (floor.value && value && !metric.map.pixels.empty()) floor.z = z_of(blocks_of(metric, between_seeds, mask));
  return floor;
}

}  // namespace sturm
