#include "pathtrace/scene/texture_file.h"

#include "io/images/image_formats.h"
#include "io/images/picture_file.h"

namespace sturm {

namespace {

Image in_linear_light(PictureFile read, TextureEncoding encoding, StatedIn stated, const std::string& name,
                      std::vector<std::string>& notes) {
  if (stated == StatedIn::Model) read.colours = {};
  if (read.values == PixelValues::Linear || encoding == TextureEncoding::Srgb) make_linear(read);
  for (const std::string& note : read.notes) notes.push_back("texture " + name + ": " + note);
  return std::move(read.picture.layers.at(""));
}

}  // namespace

Image read_texture(const std::filesystem::path& file, TextureEncoding encoding, StatedIn stated,
                   std::vector<std::string>& notes) {
  PictureFile read = read_picture_file(file);
  require_light(read.image(), file.string());
  return in_linear_light(std::move(read), encoding, stated, file.filename().string(), notes);
}

Image read_embedded_texture(std::span<const unsigned char> bytes, TextureEncoding encoding, StatedIn stated,
                            const std::string& name, std::vector<std::string>& notes) {
  return in_linear_light(read_embedded_picture(bytes, name), encoding, stated, name, notes);
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
