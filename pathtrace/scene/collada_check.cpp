#include "pathtrace/scene/collada_check.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/files/text_file.h"
#include "pathtrace/scene/xml_tags.h"

namespace sturm {
namespace {

constexpr std::size_t deepest = 1000;
constexpr std::uint64_t most_nodes = 1000000;

/// What each node holds: nodes within it and nodes that it instances, by id ("#n" for the n-th without one).
class NodeGraph {
 public:
  NodeGraph(const std::filesystem::path& file, std::string_view text) : file_(file) {
    std::vector<std::string> open;
    for (XmlTags tags(text); tags.next();) {
      const std::string_view name = tags.name();
      if (name == "/node") {
        if (!open.empty()) open.pop_back();
      } else if (name == "node") {
        std::string id = tags.attribute("id");
        if (id.empty()) id = "#" + std::to_string(++without_id_);
        if (!open.empty()) held_[open.back()].push_back(id);
        held_[id];
        if (!tags.closes_itself()) open.push_back(id);
        if (open.size() > deepest) fail(id, "nested more than " + std::to_string(deepest) + " deep", "fewer levels");
      } else if (name == "instance_node" && !open.empty()) {
        if (const std::string url = tags.attribute("url"); url.starts_with('#'))
          held_[open.back()].push_back(url.substr(1));
      }
    }
  }

  void check() {
    std::uint64_t total = 0;
    for (const auto& [id, held] : held_) total = std::max(total, unfolded(id, 0));
    if (total > most_nodes) fail("", "more than a million nodes when instances are unfolded", "fewer");
  }

 private:
  [[noreturn]] void fail(const std::string& id, const std::string& value, const std::string& expected) const {
    throw InputError(file_.string(), id.empty() ? "" : "node \"" + id + "\"", value, expected);
  }

  /// Number of nodes below and with this one, cut off beyond the limit.
  std::uint64_t unfolded(const std::string& id, std::size_t depth) {
    const auto known = count_.find(id);
    if (known != count_.end()) {
      if (known->second == 0) fail(id, "a node that holds itself", "nodes that form trees");
      return known->second;
    }
    if (depth > deepest) fail(id, "nested more than " + std::to_string(deepest) + " deep", "fewer levels");
    count_[id] = 0;  // being counted
    std::uint64_t sum = 1;
    if (const auto at = held_.find(id); at != held_.end())
      for (const std::string& inner : at->second) sum = std::min(most_nodes + 1, sum + unfolded(inner, depth + 1));
    return count_[id] = sum;
  }

  const std::filesystem::path& file_;
  std::map<std::string, std::vector<std::string>> held_;
  std::map<std::string, std::uint64_t> count_;
  int without_id_ = 0;
};

/// Whole number of an attribute; none if there is anything else.
std::optional<std::size_t> whole(const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Assimp goes on for ever where a list of indices holds anything but whole numbers, and reserves what `count` claims.
void check_lists(const std::filesystem::path& file, std::string_view text) {
  constexpr std::string_view whole_numbers = "0123456789+- \t\r\n";
  for (XmlTags tags(text); tags.next();) {
    const std::string_view name = tags.name(), content = tags.content();
    const std::string place = "<" + std::string(name) + ">";
    const bool indices = name == "p" || name == "v" || name == "h" || name == "vcount";
    if (const std::size_t odd = content.find_first_not_of(whole_numbers); indices && odd != std::string_view::npos)
      throw InputError(file.string(), place, readable(content.substr(odd, 1)),
                       "whole numbers with blanks between them");
    if (name.starts_with('/') || !name.ends_with("_array")) continue;
    const std::string count = tags.attribute("count");
    if (whole(count).value_or(text.size() + 1) > text.size())
      throw InputError(file.string(), place + ", count", readable(count, 40), "the number of values that it holds");
  }
}

/// Assimp reads what an accessor claims of an array, whether it is there or not.
void check_accessors(const std::filesystem::path& file, std::string_view text) {
  std::map<std::string, std::size_t> held;  // values of each array, by "#id"
  for (XmlTags tags(text); tags.next();)
    if (tags.name().ends_with("_array") && !tags.name().starts_with('/')) {
      const auto [array, is_new] = held.try_emplace("#" + tags.attribute("id"), text.size());
      array->second = std::min(array->second, whole(tags.attribute("count")).value_or(0));
    }
  for (XmlTags tags(text); tags.next();) {
    if (tags.name() != "accessor") continue;
    const std::string source = tags.attribute("source");
    const auto number = [&](const char* name, std::size_t usual) {
      const std::string stated = tags.attribute(name);
      const std::optional<std::size_t> value = stated.empty() ? usual : whole(stated);
      if (!value || *value > text.size())
        throw InputError(file.string(), "<accessor>, " + std::string(name), readable(stated, 40), "a whole number");
      return *value;
    };
    const std::size_t count = number("count", 0), stride = number("stride", 1), offset = number("offset", 0);
    const auto array = held.find(source);
    const std::size_t there = array == held.end() ? 0 : array->second;
    if (offset > there || (count > 0 && stride > (there - offset) / count))
      throw InputError(file.string(), "<accessor>",
                       readable(source, 40) + ": " + std::to_string(count) + " times " + std::to_string(stride) +
                           " values from " + std::to_string(offset) + " on",
                       "no more than the " + std::to_string(there) + " values that its array holds");
    if (tags.closes_itself()) continue;
    std::size_t parameters = 0;
    XmlTags within = tags;
    while (within.next() && within.name() != "/accessor") parameters += within.name() == "param";
    if (parameters > stride)
      throw InputError(file.string(), "<accessor>, stride", std::to_string(stride),
                       "at least its " + std::to_string(parameters) + " parameters");
  }
}

}  // namespace

void check_collada(const std::filesystem::path& file) {
  const std::string text = file_contents(file).value_or("");
  check_lists(file, text);
  check_accessors(file, text);
  NodeGraph(file, text).check();
}

}  // namespace sturm
