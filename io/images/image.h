#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace sturm {

/// Interleaved float image; row 0 at the top, x to the right, linear values.
struct Image {
  int width = 0, height = 0, channels = 0;  ///< columns, rows, and numbers for each pixel
  std::vector<float> pixels;                ///< height × width × channels

  Image() = default;
  Image(int width_, int height_, int channels_)
      : width(width_),
        height(height_),
        channels(channels_),
        pixels(static_cast<std::size_t>(width_) * height_ * channels_) {}  ///< all 0

  float* at(int x, int y) { return &pixels[(static_cast<std::size_t>(y) * width + x) * channels]; }  ///< of one pixel
  const float* at(int x, int y) const { return &pixels[(static_cast<std::size_t>(y) * width + x) * channels]; }
};

/// Named layers of one size, and text attributes. The main layer has the name "" (its channels are R, G, B).
/// Layer "variance" with 3 channels is stored as variance.R, variance.G, variance.B; "depth" with 1 channel as depth.Z;
/// "normal" as normal.X, normal.Y, normal.Z; other 3-channel layers as .R .G .B.
struct LayeredImage {
  std::map<std::string, Image> layers;          ///< by name
  std::map<std::string, std::string> metadata;  ///< attributes by name
};

}  // namespace sturm
