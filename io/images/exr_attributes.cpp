#include "io/images/exr_attributes.h"

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

namespace sturm {

namespace {

/// The next text that ends with a 0; false at the end of the file.
bool read_text(std::istream& file, std::string& text) {
  return static_cast<bool>(std::getline(file, text, '\0'));
}

bool read_size(std::istream& file, std::int32_t& size) {
  unsigned char bytes[4];
  if (!file.read(reinterpret_cast<char*>(bytes), sizeof bytes)) return false;
  size = static_cast<std::int32_t>(static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
                                   static_cast<std::uint32_t>(bytes[2]) << 16 |
                                   static_cast<std::uint32_t>(bytes[3]) << 24);
  return true;
}

}  // namespace

void require_honest_attributes(const std::filesystem::path& path) {
  constexpr std::int32_t several_parts = 0x1000;  // a flag of the version
  const auto file_bytes = static_cast<std::int64_t>(std::filesystem::file_size(path));
  std::ifstream file(path, std::ios::binary);
  std::int32_t magic = 0, version = 0, size = 0;
  if (!read_size(file, magic) || !read_size(file, version)) return;
  std::string name, type;
  while (read_text(file, name)) {
    // An empty name ends a header; where there are several parts, another one follows, or an empty one.
    if (name.empty() && (!(version & several_parts) || !read_text(file, name) || name.empty())) return;
    if (!read_text(file, type) || !read_size(file, size)) return;
    if (size < 0 || size > file_bytes)
      throw std::runtime_error("an attribute of " + std::to_string(size) + " bytes in a file of " +
                               std::to_string(file_bytes));
    file.seekg(size, std::ios::cur);
  }
}

}  // namespace sturm
