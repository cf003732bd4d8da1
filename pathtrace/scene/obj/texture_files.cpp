#include "pathtrace/scene/obj/texture_files.h"

#include "io/images/image_formats.h"
#include "io/images/tone_map.h"

namespace sturm {

std::shared_ptr<const Image> TextureFiles::colours(const std::filesystem::path& file, TextureEncoding encoding) {
  std::shared_ptr<const Image>& known = colours_[{file, encoding}];
  if (known) return known;
  Image stored = read_image(file);
  if (encoding == TextureEncoding::Srgb) stored = srgb_to_linear(stored);
  Image rgb(stored.width, stored.height, 3);
  const bool grey = stored.channels <= 2;
  for (int y = 0; y < rgb.height; ++y)
    for (int x = 0; x < rgb.width; ++x)
      for (int c = 0; c < 3; ++c) rgb.at(x, y)[c] = stored.at(x, y)[grey ? 0 : c];
  return known = std::make_shared<const Image>(std::move(rgb));
}

std::shared_ptr<const Image> TextureFiles::channel(const std::filesystem::path& file, char name) {
  std::shared_ptr<const Image>& known = channels_[{file, name}];
  if (known) return known;
  const Image stored = read_image(file);
  const bool grey = stored.channels <= 2, has_alpha = stored.channels == 2 || stored.channels == 4;
  const auto value = [&](const float* pixel) {
    if ((name == 0 || name == 'm') && has_alpha) return pixel[stored.channels - 1];
    if (grey) return pixel[0];
    if (name == 'r' || name == 'g' || name == 'b') return pixel[name == 'r' ? 0 : name == 'g' ? 1 : 2];
    return 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
  };
  Image one(stored.width, stored.height, 1);
  for (int y = 0; y < one.height; ++y)
    for (int x = 0; x < one.width; ++x) *one.at(x, y) = value(stored.at(x, y));
  return known = std::make_shared<const Image>(std::move(one));
}

}  // namespace sturm
