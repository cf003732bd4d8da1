#include "stages/image_files.h"

#include <string_view>

#include "io/files/atomic_file.h"
#include "io/images/exr.h"
#include "io/images/picture_file.h"
#include "io/images/png_output.h"
#include "io/images/tone_map.h"

namespace sturm {

void write_png(const std::filesystem::path& path, const Image& linear, double exposure, int bits) {
  const std::vector<unsigned char> bytes = encode_png(to_display(linear, exposure), bits);
  write_file_atomically(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void write_picture(const std::filesystem::path& path_without_suffix, const Image& linear, double exposure) {
  write_exr(path_without_suffix.string() + ".exr", LayeredImage{{{"", linear}}, {}});
  write_png(path_without_suffix.string() + ".png", linear, exposure);
}

Image read_main_layer(const std::filesystem::path& path) {
  return without_alpha(read_picture_file(path).image());
}

}  // namespace sturm
