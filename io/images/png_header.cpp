#include "io/images/png_header.h"

#include <array>
#include <fstream>
#include <string_view>

namespace sturm {

std::optional<int> png_bit_depth(const std::filesystem::path& path) {
  std::array<char, 25> start{};  // signature, length and kind of the chunk, width, height, bits
  std::ifstream file(path, std::ios::binary);
  if (!file.read(start.data(), start.size())) return std::nullopt;
  const std::string_view text(start.data(), start.size());
  if (!text.starts_with("\x89PNG\r\n\x1a\n") || text.substr(12, 4) != "IHDR") return std::nullopt;
  return static_cast<unsigned char>(text[24]);
}

}  // namespace sturm
