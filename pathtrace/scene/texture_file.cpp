#include "pathtrace/scene/texture_file.h"

#include "io/images/image_formats.h"
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

Image read_embedded_texture(std::span<const unsigned char> bytes, TextureEncoding encoding, const std::string& name) {
  Image stored = read_embedded_image(bytes, name);
  return encoding == TextureEncoding::Srgb ? srgb_to_linear(stored) : stored;
}

std::shared_ptr<const Image> colours_of(const Image& texture) {
  auto rgb = std::make_shared<Image>(texture.width, texture.height, 3);
  const bool grey = texture.channels <= 2;
  for (int y = 0; y < rgb->height; ++y)
    for (int x = 0; x < rgb->width; ++x)
      for (int c = 0; c < 3; ++c) rgb->at(x, y)[c] = texture.at(x, y)[grey ? 0 : c];
  return rgb;
}

}  // namespace sturm
