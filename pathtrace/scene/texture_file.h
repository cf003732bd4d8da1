#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/specs/scene_spec.h"

namespace sturm {

/// Where it stands what sRGB-encoded values mean.
enum class StatedIn {
  Picture,  ///< its gamma counts, and a note tells of what it says and is not followed
  Model     ///< what the picture says does not count, as glTF has it
};

/// The picture of a texture in linear light: 3 channels, or 4 where the file has alpha. Floats (EXR, HDR, PFM, float
/// TIFF) are linear as they are; 8-bit and 16-bit values mean what `encoding` says, alpha excepted. Throws InputError
/// for files that cannot be read and, with the pixel, for values that are negative or not finite. What was chosen or
/// converted on reading is added to `notes`.
Image read_texture(const std::filesystem::path& file, TextureEncoding encoding, StatedIn stated,
                   std::vector<std::string>& notes);

/// The same of a PNG or JPEG that stands inside of a model file; `name` is for messages. The same channels.
Image read_embedded_texture(std::span<const unsigned char> bytes, TextureEncoding encoding, StatedIn stated,
                            const std::string& name, std::vector<std::string>& notes);

/// Three channels of a texture of any; a grey one has three equal ones.
std::shared_ptr<const Image> colours_of(const Image& texture);

}  // namespace sturm
