#include "pathtrace/scene/collada_check.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/error.h"

namespace sturm {
namespace {

constexpr std::size_t deepest = 1000;
constexpr std::uint64_t most_nodes = 1000000;

/// The value of an attribute in the text of a tag, or "".
std::string attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const std::size_t equals = tag.find_first_not_of(" \t\r\n", at + name.size());
    if (at == 0 || std::string_view(" \t\r\n").find(tag[at - 1]) == std::string_view::npos) continue;
    if (equals == std::string_view::npos || tag[equals] != '=') continue;
    const std::size_t open = tag.find_first_of("\"'", equals);
    const std::size_t close = open == std::string_view::npos ? open : tag.find(tag[open], open + 1);
    if (close != std::string_view::npos) return std::string(tag.substr(open + 1, close - open - 1));
  }
  return {};
}

/// What each node holds: nodes within it and nodes that it instances, by id ("#n" for the n-th without one).
class NodeGraph {
 public:
  explicit NodeGraph(const std::filesystem::path& file) : file_(file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
      if (text.compare(at, 4, "<!--") == 0) {
        at = std::min(text.find("-->", at), text.size() - 1);
        continue;
      }
      const std::size_t end = std::min(text.find('>', at), text.size());
      const std::string_view tag(text.data() + at + 1, end - at - 1);
      const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/>", 1));
      if (name == "/node") {
        if (!open.empty()) open.pop_back();
      } else if (name == "node") {
        std::string id = attribute(tag, "id");
        if (id.empty()) id = "#" + std::to_string(++without_id_);
        if (!open.empty()) held_[open.back()].push_back(id);
        held_[id];
        if (!tag.ends_with('/')) open.push_back(id);
        if (open.size() > deepest) fail(id, "nested more than " + std::to_string(deepest) + " deep", "fewer levels");
      } else if (name == "instance_node" && !open.empty()) {
        if (const std::string url = attribute(tag, "url"); url.starts_with('#'))
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

}  // namespace

void check_collada(const std::filesystem::path& file) {
  NodeGraph(file).check();
}

}  // namespace sturm
