#include "io/json/foreign_file.h"

#include <array>

namespace sturm {

namespace {

using namespace std::string_view_literals;

constexpr std::array<std::pair<std::string_view, const char*>, 12> beginnings{
    {{"\x89PNG"sv, "a PNG picture"},
     {"\xFF\xD8\xFF"sv, "a JPEG picture"},
     {"\x76\x2F\x31\x01"sv, "an EXR picture"},
     {"#?RADIANCE"sv, "an HDR picture"},
     {"II*\0"sv, "a TIFF picture"},
     {"MM\0*"sv, "a TIFF picture"},
     {"glTF"sv, "a glTF model (a scene names models)"},
     {"ply\n"sv, "a PLY model (a scene names models)"},
     {"%PDF"sv, "a PDF file"},
     {"PK\x03\x04"sv, "a ZIP archive, or a file of an office program"},
     {"\x1F\x8B"sv, "a file packed by gzip"},
     {"<"sv, "an XML, HTML or SVG file"}}};

/// A first line of names with separators between them, behind remarks.
bool is_table(std::string_view contents) {
  while (contents.starts_with('#')) {
    const std::size_t end = contents.find('\n');
    if (end == std::string_view::npos) return false;
    contents.remove_prefix(end + 1);
  }
  const std::string_view line = contents.substr(0, contents.find_first_of("\r\n"));
  return line.find_first_of(",;\t") != std::string_view::npos && line.find_first_of("{}[]:") == std::string_view::npos;
}

}  // namespace

std::string other_kind_of_file(std::string_view contents) {
  for (const auto& [beginning, kind] : beginnings)
    if (contents.starts_with(beginning)) return kind;
  return is_table(contents) ? "a table (CSV)" : "";
}

}  // namespace sturm
