#include "compare/metrics/ssim.h"

#include <vector>

#include "compare/metrics/comparable.h"
#include "compare/metrics/luma.h"
#include "compare/metrics/similarity_maps.h"
#include "compare/statistics/statistics.h"
#include "io/files/error.h"

namespace sturm {

Ssim ssim(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  constexpr int taps = 2 * SimilarityMaps::margin + 1;
  if (test.width < taps || test.height < taps)
    throw InputError("", "", std::to_string(test.width) + " × " + std::to_string(test.height) + " pixels",
                     "at least 11 × 11 pixels for SSIM");
  SimilarityMaps maps = similarity_maps(luma(test), luma(reference), test.width, test.height);
  return {maps.similarity_mean, std::move(maps.similarity)};
}

std::optional<double> ssim_mean_uncertainty(const Image& map, std::uint64_t seed, int resamples) {
  require_finite(map, "similarity map");
  constexpr int block = 16;
  struct Block {
    double sum = 0.0, pixels = 0.0;
  };
  const int across = (map.width + block - 1) / block, down = (map.height + block - 1) / block;
  if (across * down < 2) return std::nullopt;
  std::vector<Block> blocks(static_cast<std::size_t>(across) * down);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      Block& b = blocks[static_cast<std::size_t>(y / block) * across + x / block];
      b.sum += *map.at(x, y);
      b.pixels += 1.0;
    }
  const auto mean = [&](std::span<const std::size_t> indices) {
    Block total;
    for (const std::size_t i : indices) total.sum += blocks[i].sum, total.pixels += blocks[i].pixels;
    return total.sum / total.pixels;
  };
  return bootstrap_standard_error(blocks.size(), mean, resamples, seed);
}

}  // namespace sturm
