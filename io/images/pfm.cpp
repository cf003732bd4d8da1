#include "io/images/pfm.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "io/files/error.h"
#include "io/files/text_file.h"

namespace sturm {

namespace {

constexpr double most_pixels = 1 << 28;

float float_at(const char* bytes, bool little) {
  unsigned char b[4];
  std::memcpy(b, bytes, sizeof b);
  if (!little) std::reverse(b, b + 4);
  return std::bit_cast<float>(static_cast<std::uint32_t>(b[0]) | static_cast<std::uint32_t>(b[1]) << 8 |
                              static_cast<std::uint32_t>(b[2]) << 16 | static_cast<std::uint32_t>(b[3]) << 24);
}

}  // namespace

Image read_pfm(const std::filesystem::path& path) {
  const std::optional<std::string> bytes = file_contents(path);
  if (!bytes) throw InputError(path.string(), "", "no such file", "a PFM file");
  std::istringstream header(bytes->substr(0, 256));
  std::string kind;
  double width = 0.0, height = 0.0, scale = 0.0;
  header >> kind >> width >> height >> scale;
  if (!header || (kind != "PF" && kind != "Pf") || !(width >= 1.0 && height >= 1.0 && scale != 0.0) ||
      width != static_cast<int>(width) || height != static_cast<int>(height))
    throw InputError(path.string(), "", "no header of a PFM file", "PF or Pf, width, height and scale");
  if (width * height > most_pixels) throw InputError(path.string(), "", "too many pixels", "at most 2^28");
  Image image(static_cast<int>(width), static_cast<int>(height), kind == "PF" ? 3 : 1);
  const std::size_t first = static_cast<std::size_t>(header.tellg()) + 1, row = 4 * image.pixels.size() / image.height;
  if (bytes->size() < first + row * image.height)
    throw InputError(path.string(), "", std::to_string(bytes->size()) + " bytes",
                     std::to_string(first + row * image.height) + " for its header");
  for (int y = 0; y < image.height; ++y) {
    const char* from = bytes->data() + first + row * static_cast<std::size_t>(image.height - 1 - y);
    for (std::size_t i = 0; i < row / 4; ++i) image.at(0, y)[i] = float_at(from + 4 * i, scale < 0.0);
  }
  return image;
}

}  // namespace sturm
