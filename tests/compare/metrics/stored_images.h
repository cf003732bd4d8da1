#pragma once
#include <cmath>
#include <string>

#include "io/images/exr.h"
#include "support/source_folder.h"

namespace sturm::testing {

/// One of the three pictures of tests/reference/images.
inline Image stored_image(const std::string& name) {
  return read_exr(STURM_SOURCE_DIR "/tests/reference/images/" + name + ".exr").layers.at("");
}

inline Image uniform_image(int width, int height, float red, float green, float blue) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3)
    image.pixels[i] = red, image.pixels[i + 1] = green, image.pixels[i + 2] = blue;
  return image;
}

/// A reproducible pattern with structure at every scale, values in [0, 1].
inline Image textured_image(int width, int height, double phase) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<float>(0.5 + 0.25 * std::sin(0.31 * x + 0.05 * y * c + phase) +
                                               0.2 * std::cos(0.011 * x * y + phase));
  return image;
}

}  // namespace sturm::testing
