#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "io/images/picture_file.h"

namespace sturm {

/// The picture of an EXR file, as read_picture_file has it. Throws InputError.
PictureFile read_exr_picture(const std::filesystem::path& path, const std::optional<std::string>& layer);

/// The distances in an EXR file, as stored: the layer that means them (io/images/exr_layers.h), else the only or main
/// one with all of its channels. Throws InputError.
Image read_exr_depth(const std::filesystem::path& path);

}  // namespace sturm
