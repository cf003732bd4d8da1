#include "pathtrace/scene/collada_shift.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include "io/files/text_file.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/xml_tags.h"

namespace sturm {
namespace {

/// A list of numbers, where it stands in the text.
struct Source {
  std::size_t begin = 0, end = 0;
  std::string stride;
};

std::optional<std::vector<double>> numbers_of(std::string_view list) {
  std::vector<double> numbers;
  const char *at = list.data(), *end = list.data() + list.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\n')) ++at;
    if (at == end) return numbers;
    if (*at == '+') ++at;
    const auto [behind, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc()) return std::nullopt;
    at = behind;
  }
}

class Shift {
 public:
  explicit Shift(std::string text) : text_(std::move(text)) {}

  ShiftedCollada run() {
    std::string geometry, source, positions;
    bool in_vertices = false;
    for (XmlTags tags(text_); tags.next();) {
      const std::string_view name = tags.name();
      if (name == "geometry") {
        geometry = tags.attribute("id");
        sources_.clear();
        positions.clear();
      }
      if (name == "source") source = tags.attribute("id");
      if (name == "float_array") {
        sources_[source].begin = tags.end();
        sources_[source].end = tags.end() + tags.content().size();
      }
      if (name == "accessor") sources_[source].stride = tags.attribute("stride");
      if (name == "vertices" || name == "/vertices") in_vertices = name[0] != '/';
      if (name == "input" && in_vertices && tags.attribute("semantic") == "POSITION")
        positions = tags.attribute("source");
      if (name == "/geometry" && positions.starts_with('#')) shift(geometry, positions.substr(1));
    }
    result_.text += std::string_view(text_).substr(copied_);
    return std::move(result_);
  }

 private:
  void shift(const std::string& geometry, const std::string& name) {
    const auto at = sources_.find(name);
    if (at == sources_.end() || at->second.stride != "3" || at->second.begin < copied_) return;
    const Source& source = at->second;
    const auto numbers = numbers_of(std::string_view(text_).substr(source.begin, source.end - source.begin));
    if (!numbers || numbers->size() < 3) return;
    result_.offsets[geometry] = Eigen::Vector3d(numbers->data());
    result_.text += std::string_view(text_).substr(copied_, source.begin - copied_);
    for (std::size_t i = 0; i < numbers->size(); ++i)
      result_.text += exact_number((*numbers)[i] - (*numbers)[i % 3]) + " ";
    copied_ = source.end;
  }

  std::string text_;
  std::map<std::string, Source> sources_;  // of the geometry
  std::size_t copied_ = 0;                 // of the text, into the result
  ShiftedCollada result_;
};

}  // namespace

ShiftedCollada shifted_collada(const std::filesystem::path& file) {
  return Shift(file_contents(file).value_or("")).run();
}

}  // namespace sturm
