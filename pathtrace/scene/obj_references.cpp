#include "pathtrace/scene/obj_references.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include "io/files/error.h"

namespace sturm {
namespace {

constexpr std::string_view blanks = " \t\r";

/// The rest of `line` behind `keyword` and blanks, trimmed; empty where the line is another statement.
std::string argument(std::string_view line, std::string_view keyword) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  if (!line.starts_with(keyword) || line.size() == keyword.size() ||
      blanks.find(line[keyword.size()]) == std::string_view::npos)
    return {};
  line.remove_prefix(keyword.size());
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return std::string(line.substr(0, line.find_last_not_of(blanks) + 1));
}

std::string at_line(const std::filesystem::path& file, long line) {
  return file.string() + ":" + std::to_string(line);
}

}  // namespace

void check_obj_references(const std::filesystem::path& obj_file) {
  std::ifstream obj(obj_file);
  std::set<std::string> defined;
  std::string text;
  for (long line = 1; std::getline(obj, text); ++line) {
    if (const std::string name = argument(text, "mtllib"); !name.empty()) {
      const auto library_file = obj_file.parent_path() / name;
      std::ifstream library(library_file);
      if (!library)
        throw InputError(at_line(obj_file, line), "mtllib", library_file.string(),
                         "a material library that exists and can be read");
      while (std::getline(library, text))
        if (const std::string material = argument(text, "newmtl"); !material.empty()) defined.insert(material);
    } else if (const std::string used = argument(text, "usemtl"); !used.empty() && !defined.contains(used)) {
      throw InputError(at_line(obj_file, line), "usemtl", used, "a material that a library named before defines");
    }
  }
}

}  // namespace sturm
