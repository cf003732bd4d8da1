#pragma once
#include <cstddef>

#include "io/images/image.h"

namespace sturm {

/// Every colour changed; the last of 2 or 4 channels is alpha and stays as it is.
template <class Change>
Image changed_colours(Image image, const Change& change) {
  const int coloured = image.channels % 2 == 0 ? image.channels - 1 : image.channels;
  for (std::size_t start = 0; start < image.pixels.size(); start += static_cast<std::size_t>(image.channels))
    for (std::size_t i = start; i < start + static_cast<std::size_t>(coloured); ++i)
      image.pixels[i] = change(image.pixels[i]);
  return image;
}

}  // namespace sturm
