#include "pathtrace/scene/stated_positions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/text_file.h"
#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {
namespace {

/// Takes a line off a text, whatever ends it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  return trimmed(line);
}

std::size_t bytes_of(std::string_view type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32" || type == "float" || type == "float32")
    return 4;
  return type == "double" || type == "float64" ? 8 : 0;
}

/// What a PLY file's header says of its vertices.
struct PlyVertices {
  std::string format;
  std::size_t lines_before = 0, bytes_before = 0;  ///< of other elements
  std::size_t count = 0, words = 0, bytes = 0;     ///< of one vertex: words and bytes
  std::array<std::size_t, 3> word{}, byte{};       ///< where x, y, z are
  int found = 0;
  bool doubles = true, plain = true;  ///< plain: no lists up to and in the vertices
};

std::optional<PlyVertices> ply_header(std::string_view& text) {
  PlyVertices ply;
  bool in_vertices = false, behind = false;
  std::size_t others = 0;
  if (take_line(text) != "ply") return std::nullopt;
  for (std::string_view line = take_line(text); line != "end_header"; line = take_line(text)) {
    if (text.empty()) return std::nullopt;
    const std::string_view word = take_word(line);
    if (word == "format") ply.format = take_word(line);
    if (word == "element") {
      behind = behind || in_vertices;
      in_vertices = take_word(line) == "vertex";
      const std::size_t count = static_cast<std::size_t>(number_of(take_word(line)).value_or(0.0));
      (in_vertices ? ply.count : others) = count;
      if (!in_vertices && !behind) ply.lines_before += count;
    }
    if (word != "property" || behind) continue;
    const std::string_view type = take_word(line), name = take_word(line);
    ply.plain = ply.plain && bytes_of(type) > 0;
    if (!in_vertices) {
      ply.bytes_before += others * bytes_of(type);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
      if (name == std::string_view("xyz").substr(k, 1)) {
        ply.word[k] = ply.words;
        ply.byte[k] = ply.bytes;
        ply.doubles = ply.doubles && bytes_of(type) == 8;
        ++ply.found;
      }
    ++ply.words;
    ply.bytes += bytes_of(type);
  }
  return ply.found == 3 ? std::optional(ply) : std::nullopt;
}

std::vector<Eigen::Vector3d> ply_text(std::string_view text, const PlyVertices& ply) {
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t i = 0; i < ply.lines_before; ++i) take_line(text);
  for (std::size_t i = 0; i < ply.count && !text.empty(); ++i) {
    std::string_view line = take_line(text);
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (std::size_t at = 0; at < ply.words; ++at) {
      const auto number = number_of(take_word(line));
      for (std::size_t k = 0; k < 3; ++k)
        if (ply.word[k] == at) position[static_cast<Eigen::Index>(k)] = number.value_or(0.0);
    }
    positions.push_back(position);
  }
  return positions;
}

std::vector<Eigen::Vector3d> ply_bytes(std::string_view bytes, const PlyVertices& ply) {
  std::vector<Eigen::Vector3d> positions;
  if (ply.bytes_before > bytes.size()) return positions;
  bytes.remove_prefix(ply.bytes_before);
  for (std::size_t i = 0; i < ply.count && bytes.size() >= ply.bytes; ++i, bytes.remove_prefix(ply.bytes)) {
    Eigen::Vector3d position;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<char, 8> number;
      std::memcpy(number.data(), bytes.data() + ply.byte[k], 8);
      if (ply.format == "binary_big_endian") std::reverse(number.begin(), number.end());
      position[static_cast<Eigen::Index>(k)] = std::bit_cast<double>(number);
    }
    positions.push_back(position);
  }
  return positions;
}

std::vector<Eigen::Vector3d> stl_text(std::string_view text) {
  std::vector<Eigen::Vector3d> positions;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    if (lower_case(take_word(line)) != "vertex") continue;
    Eigen::Vector3d& position = positions.emplace_back();
    for (int k = 0; k < 3; ++k) position[k] = number_of(take_word(line)).value_or(0.0);
  }
  return positions;
}

}  // namespace

std::vector<Eigen::Vector3d> stated_positions(const std::filesystem::path& file) {
  const std::string bytes = file_contents(file).value_or("");
  std::string_view text = bytes;
  if (lower_case(text.substr(0, 5)) == "solid") return stl_text(text);
  const auto ply = ply_header(text);
  if (!ply) return {};
  if (ply->format == "ascii") return ply_text(text, *ply);
  return ply->plain && ply->doubles ? ply_bytes(text, *ply) : std::vector<Eigen::Vector3d>{};
}

}  // namespace sturm
