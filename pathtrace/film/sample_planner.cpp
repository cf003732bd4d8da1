#include "pathtrace/film/sample_planner.h"

#include <cmath>
#include <numeric>

namespace sturm {

SamplePlanner::SamplePlanner(std::vector<int> tile_pixels, double relative_error, bool per_tile)
    : target_(relative_error * relative_error), per_tile_(per_tile) {
  const double all = std::accumulate(tile_pixels.begin(), tile_pixels.end(), 0.0);
  for (const int pixels : tile_pixels) tiles_.push_back({pixels / all});
}

void SamplePlanner::measured(std::size_t tile, std::uint32_t samples, double squared_error) {
  tiles_[tile].samples = samples;
  tiles_[tile].squared_error = squared_error;
}

void SamplePlanner::decide() {
  double error = 0.0, mean_sigma = 0.0;
  for (const Tile& t : tiles_) {
    error += t.share * t.squared_error;
    mean_sigma += t.share * std::sqrt(t.squared_error * t.samples);
  }
  const bool good_enough = error <= target_;
  for (Tile& t : tiles_) {
    const double needed = std::sqrt(t.squared_error * t.samples) * mean_sigma / target_;
    if (good_enough || (per_tile_ && needed <= t.samples)) t.active = false;
  }
}

}  // namespace sturm
