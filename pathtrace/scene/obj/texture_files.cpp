#include "pathtrace/scene/obj/texture_files.h"

#include "pathtrace/scene/texture_file.h"

namespace sturm {

std::shared_ptr<const Image> TextureFiles::colours(const std::filesystem::path& file, TextureEncoding encoding) {
  std::shared_ptr<const Image>& known = colours_[{file, encoding}];
  if (!known) known = colours_of(read_texture(file, encoding, StatedIn::Picture, notes_));
  return known;
}

std::shared_ptr<const Image> TextureFiles::channel(const std::filesystem::path& file, char name) {
  std::shared_ptr<const Image>& known = channels_[{file, name}];
  if (known) return known;
  const Image stored = read_texture(file, TextureEncoding::Linear, StatedIn::Picture, notes_);
  const auto value = [&](const float* pixel) {
    if ((name == 0 || name == 'm') && stored.channels == 4) return pixel[3];
    if (name == 'r' || name == 'g' || name == 'b') return pixel[name == 'r' ? 0 : name == 'g' ? 1 : 2];
    return 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
  };
  Image one(stored.width, stored.height, 1);
  for (int y = 0; y < one.height; ++y)
    for (int x = 0; x < one.width; ++x) *one.at(x, y) = value(stored.at(x, y));
  return known = std::make_shared<const Image>(std::move(one));
}

}  // namespace sturm
