#include "io/images/exr_attributes.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "io/files/readable_text.h"

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

/// Bytes of the types whose size is fixed ["OpenEXR File Layout", predefined attribute types]; OpenEXR reads so many,
/// whatever the file says.
std::optional<std::int32_t> fixed_size(const std::string& type) {
  static const std::map<std::string, std::int32_t> sizes = {{"box2i", 16},
                                                            {"box2f", 16},
                                                            {"chromaticities", 32},
                                                            {"compression", 1},
                                                            {"deepImageState", 1},
                                                            {"double", 8},
                                                            {"envmap", 1},
                                                            {"float", 4},
                                                            {"int", 4},
                                                            {"keycode", 28},
                                                            {"lineOrder", 1},
                                                            {"m33d", 72},
                                                            {"m33f", 36},
                                                            {"m44d", 128},
                                                            {"m44f", 64},
                                                            {"rational", 8},
                                                            {"tiledesc", 9},
                                                            {"timecode", 8},
                                                            {"v2d", 16},
                                                            {"v2f", 8},
                                                            {"v2i", 8},
                                                            {"v3d", 24},
                                                            {"v3f", 12},
                                                            {"v3i", 12}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? std::nullopt : std::optional(found->second);
}

/// Whether a list of channels (each a name and 16 bytes) ends with its last byte, where OpenEXR looks for its end.
bool is_whole_channel_list(const std::string& bytes) {
  constexpr std::size_t after_name = 16;
  std::size_t at = 0;
  while (at < bytes.size() && bytes[at] != '\0') {
    at = bytes.find('\0', at);
    if (at == std::string::npos) return false;
    at += 1 + after_name;
  }
  return at + 1 == bytes.size();
}

/// Whether a small picture has as many bytes as its size says.
bool is_whole_preview(std::istream& file, std::int32_t size) {
  constexpr std::int32_t size_bytes = 8, pixel_bytes = 4;
  std::int32_t width = 0, height = 0;
  return size >= size_bytes && size % pixel_bytes == 0 && read_size(file, width) && read_size(file, height) &&
         width >= 0 && height >= 0 && std::int64_t{width} * height == (size - size_bytes) / pixel_bytes;
}

/// Whether an attribute's value is as long as its type has it; reads from where the value starts.
bool fits_its_type(std::istream& file, const std::string& type, std::int32_t size) {
  if (type == "preview") return is_whole_preview(file, size);
  if (type != "chlist") return size == fixed_size(type).value_or(size);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  return file.read(bytes.data(), size) && is_whole_channel_list(bytes);
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
    const auto value = file.tellg();
    if (!fits_its_type(file, type, size))
      throw std::runtime_error("an attribute of " + std::to_string(size) + " bytes that its type \"" +
                               readable(type, 40) + "\" does not have");
    file.clear();
    file.seekg(value + std::streamoff{size});
  }
}

}  // namespace sturm
