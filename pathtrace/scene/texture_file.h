#pragma once
#include <filesystem>
#include <memory>
#include <span>
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

/// The same of a PNG or JPEG that stands inside of a model file; `name` is for messages. Channels as stored.
Image read_embedded_texture(std::span<const unsigned char> bytes, TextureEncoding encoding, const std::string& name);

/// Three channels of a texture of any; a grey one has three equal ones.
std::shared_ptr<const Image> colours_of(const Image& texture);

}  // namespace sturm
