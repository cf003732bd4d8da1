#pragma once
#include <string>

#include "io/images/image.h"

namespace sturm {

/// Throws InputError unless `image` has pixels and all of them are finite; the message names `name`, the pixel and the
/// channel.
void require_finite(const Image& image, const std::string& name);

/// Throws InputError unless both images have the same width, height and channels, and finite pixels.
void require_comparable(const Image& test, const Image& reference);

/// The same, and both have three channels.
void require_colour_pair(const Image& test, const Image& reference);

}  // namespace sturm
