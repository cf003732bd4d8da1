#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/specs/scene_spec.h"

namespace sturm {

/// The picture of a texture in linear light: 3 channels, or 4 where the file has alpha. Floats (EXR, HDR, PFM, float
/// TIFF) are linear as they are; 8-bit and 16-bit values mean what `encoding` says, alpha excepted. Throws InputError
/// for files that cannot be read and, with the pixel, for values that are negative or not finite. What was chosen or
/// converted on reading is added to `notes`.
Image read_texture(const std::filesystem::path& file, TextureEncoding encoding, std::vector<std::string>& notes);

}  // namespace sturm
