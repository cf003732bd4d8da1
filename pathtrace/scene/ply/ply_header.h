#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// How a PLY file stores a number.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(PlyType type);
inline bool is_whole(PlyType type) {
  return type < PlyType::float32;
}

struct PlyProperty {
  std::string name;
  PlyType type;                  ///< of the number, or of each in a list
  std::optional<PlyType> count;  ///< of a list, how its length is stored
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes that one of them takes at least: its numbers without what is in its lists; as text, a digit and a blank
  /// each.
  std::size_t least_bytes(bool as_text) const;
};

/// What a PLY file says of itself (Turk, "The PLY Polygon File Format", 1994).
struct PlyHeader {
  enum class Encoding { text, little_endian, big_endian };

  Encoding encoding = Encoding::text;
  std::vector<PlyElement> elements;
  std::vector<std::string> textures;  ///< files that a comment names ("comment TextureFile NAME", as scanners write it)
  std::size_t bytes = 0;              ///< of the header; the first element follows
  long lines = 0;                     ///< of the header
};

/// Reads the header at the start of `file`, whose bytes are given; its lines may end in LF, CR LF or CR. Throws
/// InputError that names file and line: no header, an unknown type, a property or an element stated twice, more
/// elements than the rest of the file has room for.
PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace sturm
