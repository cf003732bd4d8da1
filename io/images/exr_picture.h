#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "io/images/picture_file.h"

namespace sturm {

/// The picture of an EXR file, as read_picture_file has it. Throws InputError.
PictureFile read_exr_picture(const std::filesystem::path& path, const std::optional<std::string>& layer);

}  // namespace sturm
