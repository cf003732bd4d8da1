#include "compare/metrics/comparable.h"

#include <cmath>

#include "io/files/error.h"

namespace sturm {

namespace {
std::string size_text(const Image& i) {
  return std::to_string(i.width) + " × " + std::to_string(i.height) + " pixels of " + std::to_string(i.channels) +
         " channels";
}
}  // namespace

void require_finite(const Image& image, const std::string& name) {
  if (image.pixels.empty()) throw InputError("", "", "an empty " + name, "an image with pixels");
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (std::isfinite(image.pixels[i])) continue;
    const std::size_t pixel = i / image.channels;
    throw InputError("", "",
                     name + " with a non-finite value at x = " + std::to_string(pixel % image.width) + ", y = " +
                         std::to_string(pixel / image.width) + ", channel " + std::to_string(i % image.channels),
                     "finite pixels");
  }
}

void require_comparable(const Image& test, const Image& reference) {
  if (test.width != reference.width || test.height != reference.height || test.channels != reference.channels)
    throw InputError("", "", size_text(test), "the size of the reference image, " + size_text(reference));
  require_finite(test, "test image");
  require_finite(reference, "reference image");
}

void require_colour_pair(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  if (test.channels != 3) throw InputError("", "", size_text(test), "red, green and blue");
}

}  // namespace sturm
