#include "pathtrace/scene/ply_check.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "io/files/error.h"
#include "io/files/readable_text.h"

namespace sturm {

namespace {

bool is_type(const std::string& word) {
  static constexpr std::string_view types[] = {"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                               "float", "double", "int8",    "uint8",  "int16", "uint16",
                                               "int32", "uint32", "float32", "float64"};
  return std::find(std::begin(types), std::end(types), word) != std::end(types);
}

bool is_name(const std::string& word) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
  return is_letter(word.front()) && std::all_of(word.begin(), word.end(), [&](char c) {
           return is_letter(c) || std::isdigit(static_cast<unsigned char>(c));
         });
}

/// Whether the words behind "property" are a type and a name, or a list with its two types.
bool is_property(std::istringstream& words) {
  std::string type, of_count, of_items, name;
  words >> type;
  if (type != "list") return is_type(type) && words >> name;
  return words >> of_count >> of_items >> name && is_type(of_count) && is_type(of_items);
}

}  // namespace

void check_ply(const std::filesystem::path& file) {
  const auto file_bytes = static_cast<double>(std::filesystem::file_size(file));
  std::ifstream lines(file, std::ios::binary);
  const auto fail = [&](int number, const std::string& value, const char* expected) {
    throw InputError(file.string() + ", line " + std::to_string(number), "", readable(value, 60), expected);
  };
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string statement, name;
    double count = 0.0;
    words >> statement;
    if (number == 1 && statement != "ply") fail(number, statement, "ply");
    if (statement == "end_header") return;
    if (statement == "element") {
      std::string more;
      if (!(words >> name >> count) || !is_name(name) || words >> more)
        fail(number, line, "an element with its name and number");
      if (!(count >= 0.0 && count <= file_bytes)) fail(number, line, "no more elements than the file has bytes");
    } else if (statement == "property") {
      if (!is_property(words)) fail(number, line, "a property with its type and name");
    } else if (number > 1 && statement != "format" && statement != "comment" && statement != "obj_info" &&
               !statement.empty()) {
      fail(number, line, "a statement of a PLY header");
    }
  }
  throw InputError(file.string(), "", "no end_header", "a PLY file with a whole header");
}

}  // namespace sturm
