#include "pathtrace/scene/stated_positions.h"

#include <algorithm>
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
  const std::string text = file_contents(file).value_or("");
  return lower_case(std::string_view(text).substr(0, 5)) == "solid" ? stl_text(text) : std::vector<Eigen::Vector3d>{};
}

}  // namespace sturm
