#pragma once
#include <array>
#include <vector>

namespace sturm {

/// Two independent estimates of one pixel.
struct PixelPair {
  std::array<double, 3> first, second;
};

/// Relative squared error of the means (first + second)/2 of a tile of `width` pixels across, averaged over pixels and
/// channels:
/// ((first − second)/2)², whose expectation is the variance of that mean, over r² + 0.01 as in the metric relative MSE,
/// r being the mean of the 3 × 3 neighbours within the tile: a pixel's own value would shrink the error of rare bright
/// samples.
double tile_squared_error(const std::vector<PixelPair>& pixels, int width);

}  // namespace sturm
