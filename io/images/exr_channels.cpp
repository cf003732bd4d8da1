#include "io/images/exr_channels.h"

#include <set>

namespace sturm {

namespace {

std::string full_name(const std::string& layer, const std::string& channel) {
  return layer.empty() ? channel : layer + "." + channel;
}

std::vector<std::string> full_names(const std::string& layer, const std::vector<std::string>& channels) {
  std::vector<std::string> names;
  for (const std::string& channel : channels) names.push_back(full_name(layer, channel));
  return names;
}

/// Groups that make up a layer, the larger ones first.
const std::vector<std::vector<std::string>>& known_groups() {
  static const std::vector<std::vector<std::string>> groups = {{"R", "G", "B", "A"}, {"R", "G", "B"}, {"X", "Y", "Z"},
                                                               {"X", "Y"},           {"Y"},           {"Z"}};
  return groups;
}

bool contains_all(const std::set<std::string>& set, const std::vector<std::string>& group) {
  for (const std::string& channel : group)
    if (!set.contains(channel)) return false;
  return true;
}

}  // namespace

std::vector<std::string> exr_channel_names(const std::string& layer, int channels) {
  switch (channels) {
    case 1:
      return full_names(layer, {layer == "depth" ? "Z" : "Y"});
    case 2:
      return full_names(layer, {"X", "Y"});
    case 3:
      return full_names(
          layer, layer == "normal" ? std::vector<std::string>{"X", "Y", "Z"} : std::vector<std::string>{"R", "G", "B"});
    case 4:
      return full_names(layer, {"R", "G", "B", "A"});
    default:
      return {};
  }
}

std::map<std::string, std::vector<std::string>> layers_of_channels(const std::vector<std::string>& channels) {
  std::map<std::string, std::set<std::string>> by_prefix;
  for (const std::string& channel : channels) {
    const std::size_t dot = channel.rfind('.');
    const std::string prefix = dot == std::string::npos ? "" : channel.substr(0, dot);
    by_prefix[prefix].insert(dot == std::string::npos ? channel : channel.substr(dot + 1));
  }
  std::map<std::string, std::vector<std::string>> layers;
  for (auto& [prefix, rest] : by_prefix) {
    for (const auto& group : known_groups())
      if (contains_all(rest, group)) {
        layers[prefix] = full_names(prefix, group);
        for (const std::string& channel : group) rest.erase(channel);
        break;
      }
    for (const std::string& channel : rest) layers.insert({full_name(prefix, channel), {full_name(prefix, channel)}});
  }
  return layers;
}

}  // namespace sturm
