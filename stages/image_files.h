#pragma once
#include <filesystem>

#include "io/images/image.h"

namespace sturm {

/// Writes `path_without_suffix`.exr (linear) and .png (display space, see io/images/tone_map.h).
void write_picture(const std::filesystem::path& path_without_suffix, const Image& linear, double exposure);

/// Writes the display version of a linear 3-channel image as PNG of 8 or 16 bits.
void write_png(const std::filesystem::path& path, const Image& linear, double exposure, int bits = 8);

/// Reads the picture of an EXR as R, G, B (io/images/picture_file.h). Throws InputError where it has none.
Image read_main_layer(const std::filesystem::path& path);

}  // namespace sturm
