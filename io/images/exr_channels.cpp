#include "io/images/exr_channels.h"

#include <algorithm>

#include "io/files/lower_case.h"

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

/// The channels of one layer by what they are in it.
using ChannelsByRole = std::map<std::string, std::string>;

bool contains_all(const ChannelsByRole& channels, const std::vector<std::string>& group) {
  for (const std::string& role : group)
    if (!channels.contains(role)) return false;
  return true;
}

std::string without_leading_dots(const std::string& channel) {
  return channel.substr(std::min(channel.find_first_not_of('.'), channel.size()));
}

/// The part behind the last dot.
std::string last_part(const std::string& channel) {
  return channel.substr(channel.rfind('.') + 1);  // npos + 1 = 0
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

std::string channel_layer(const std::string& channel) {
  const std::string name = without_leading_dots(channel);
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string channel_role(const std::string& channel) {
  static const std::map<std::string, std::string> roles = {{"r", "R"},     {"g", "G"},    {"b", "B"},    {"a", "A"},
                                                           {"x", "X"},     {"y", "Y"},    {"z", "Z"},    {"red", "R"},
                                                           {"green", "G"}, {"blue", "B"}, {"alpha", "A"}};
  const std::string part = last_part(channel);
  const auto role = roles.find(lower_case(part));
  return role == roles.end() ? part : role->second;
}

std::map<std::string, std::vector<std::string>> layers_of_channels(const std::vector<std::string>& channels) {
  std::map<std::string, std::vector<std::string>> layers;
  std::map<std::string, ChannelsByRole> by_layer;
  const auto stands_alone = [&](const std::string& channel) {
    layers.insert({without_leading_dots(channel), {channel}});
  };
  for (const std::string& channel : channels) {
    const std::string role = channel_role(channel);
    const auto [known, is_new] = by_layer[channel_layer(channel)].insert({role, channel});
    if (is_new) continue;
    const bool better = last_part(channel) == role && last_part(known->second) != role;
    stands_alone(better ? known->second : channel);
    if (better) known->second = channel;
  }
  for (auto& [layer, rest] : by_layer) {
    for (const auto& group : known_groups())
      if (contains_all(rest, group)) {
        for (const std::string& role : group) {
          layers[layer].push_back(rest.at(role));
          rest.erase(role);
        }
        break;
      }
    for (const auto& [role, channel] : rest) stands_alone(channel);
  }
  return layers;
}

}  // namespace sturm
