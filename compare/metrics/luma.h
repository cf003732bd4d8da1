#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// Rec. 709 luma .2126 R + .7152 G + .0722 B of each pixel, in whatever space the image is; a one-channel image is its
/// own luma. Throws InputError for any other number of channels.
std::vector<double> luma(const Image& image);

}  // namespace sturm
