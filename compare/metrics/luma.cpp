#include "compare/metrics/luma.h"

#include "io/files/error.h"

namespace sturm {

std::vector<double> luma(const Image& image) {
  if (image.channels == 1) return {image.pixels.begin(), image.pixels.end()};
  if (image.channels != 3)
    throw InputError("", "", "an image of " + std::to_string(image.channels) + " channels", "1 or 3 channels");
  std::vector<double> result(image.pixels.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = 0.2126 * image.pixels[3 * i] + 0.7152 * image.pixels[3 * i + 1] + 0.0722 * image.pixels[3 * i + 2];
  return result;
}

}  // namespace sturm
