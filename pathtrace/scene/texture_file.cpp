#include "pathtrace/scene/texture_file.h"

#include "io/images/picture_file.h"
#include "io/images/tone_map.h"

namespace sturm {

Image read_texture(const std::filesystem::path& file, TextureEncoding encoding, std::vector<std::string>& notes) {
  PictureFile read = read_picture_file(file);
  for (const std::string& note : read.notes) notes.push_back("texture " + file.filename().string() + ": " + note);
  Image& picture = read.picture.layers.at("");
  require_light(picture, file.string());
  const bool decode = read.values == PixelValues::Display && encoding == TextureEncoding::Srgb;
  return decode ? srgb_to_linear(picture) : std::move(picture);
}

}  // namespace sturm
