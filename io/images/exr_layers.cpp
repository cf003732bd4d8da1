#include "io/images/exr_layers.h"

#include <OpenEXR/ImfHeader.h>

#include <algorithm>
#include <map>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/readable_text.h"
#include "io/images/exr_channels.h"

namespace sturm {

namespace {

constexpr std::size_t most_listed = 60;

/// The name of a layer of a part.
std::string name_of(const std::string& part, const std::string& layer, bool several_parts) {
  const std::string plain = lower_case(part);
  if (!several_parts || part.empty() || plain == "rgba" || plain == "rgb") return layer;
  if (layer.empty() || layer == part) return part;
  return layer.starts_with(part + ".") ? layer : part + "." + layer;
}

ExrLayer::Kind kind_of(const ExrReader& file, int part, const std::string& layer,
                       const std::vector<std::string>& channels) {
  const std::string first = channel_role(channels.front());
  if (channels.size() >= 3 && first == "R") return ExrLayer::Kind::Colours;
  if (channels.size() != 1 || first != "Y") return ExrLayer::Kind::Other;
  const std::string prefix = layer.empty() ? "" : layer + ".";
  return file.has_channel(part, prefix + "RY") && file.has_channel(part, prefix + "BY")
             ? ExrLayer::Kind::LuminanceAndChroma
             : ExrLayer::Kind::Luminance;
}

bool is_picture(const ExrLayer& layer) {
  return layer.kind != ExrLayer::Kind::Other;
}

std::string in_words(const ExrLayer& layer) {
  return layer.name.empty() ? "\"\" (the main one)" : "\"" + readable(layer.name, 80) + "\"";
}

/// Pictures first, then what else could be asked for.
std::string list_of(const std::vector<ExrLayer>& layers) {
  std::string text;
  std::size_t listed = 0;
  for (const bool pictures : {true, false})
    for (const ExrLayer& layer : layers) {
      if (is_picture(layer) != pictures || ++listed > most_listed) continue;
      text += (text.empty() ? "" : ", ") + in_words(layer);
    }
  if (listed > most_listed) text += " and " + std::to_string(listed - most_listed) + " more";
  return text.empty() ? "a layer (the file has none)" : text;
}

/// The only layer for which `holds`; null where there is none or several.
template <class Condition>
const ExrLayer* only_one(const std::vector<ExrLayer>& layers, const Condition& holds) {
  const auto first = std::find_if(layers.begin(), layers.end(), holds);
  if (first == layers.end() || std::find_if(first + 1, layers.end(), holds) != layers.end()) return nullptr;
  return &*first;
}

const ExrLayer* named_layer(const std::vector<ExrLayer>& layers, const std::string& wanted) {
  if (const auto* exact = only_one(layers, [&](const ExrLayer& l) { return l.name == wanted; })) return exact;
  const std::string word = lower_case(wanted);
  if (const auto* like = only_one(layers, [&](const ExrLayer& l) { return lower_case(l.name) == word; })) return like;
  const bool means_main = word == "main" || word == "rgba" || word == "rgb";
  return only_one(layers, [&](const ExrLayer& l) {
    const std::string name = lower_case(l.name);
    return (means_main && name.empty()) ||
           (is_picture(l) && (lower_case(channel_layer(l.channels.front())) == word || name.starts_with(word + ".") ||
                              name.ends_with("." + word)));
  });
}

bool means_depth(const std::string& name) {
  const std::string word = lower_case(name.substr(name.rfind('.') + 1));  // npos + 1 = 0
  return word == "depth" || word == "z";
}

}  // namespace

std::vector<ExrLayer> layers_of(const ExrReader& file) {
  std::vector<ExrLayer> layers;
  std::map<std::string, int> uses;
  for (int part = 0; part < file.parts(); ++part) {
    const std::string part_name = file.header(part).hasName() ? file.header(part).name() : "";
    for (auto& [layer, channels] : layers_of_channels(file.channels(part))) {
      const ExrLayer::Kind kind = kind_of(file, part, layer, channels);
      std::string name = name_of(part_name, layer, file.parts() > 1);
      if (name.empty() && kind == ExrLayer::Kind::Other)  // the main layer is a picture
        for (const std::string& channel : channels) name += channel_role(channel);
      if (const int use = ++uses[name]; use > 1) name += "#" + std::to_string(use);
      layers.push_back({name, kind, part, channels});
    }
  }
  return layers;
}

const ExrLayer& chosen_layer(const std::vector<ExrLayer>& layers, const std::optional<std::string>& wanted,
                             const std::string& file) {
  if (wanted) {
    const ExrLayer* layer = named_layer(layers, *wanted);
    if (!layer) throw InputError(file, "", "no layer \"" + readable(*wanted, 80) + "\"", "one of " + list_of(layers));
    if (layer->channels.size() == 2)
      throw InputError(file, "", "layer " + in_words(*layer) + " of two channels", "one of " + list_of(layers));
    return *layer;
  }
  for (const auto& kinds : {std::vector{ExrLayer::Kind::Colours},
                            std::vector{ExrLayer::Kind::Luminance, ExrLayer::Kind::LuminanceAndChroma}}) {
    const auto fits = [&](const ExrLayer& l) { return std::find(kinds.begin(), kinds.end(), l.kind) != kinds.end(); };
    if (const auto* main = only_one(layers, [&](const ExrLayer& l) { return fits(l) && l.name.empty(); })) return *main;
    if (const auto* single = only_one(layers, fits)) return *single;
    if (std::any_of(layers.begin(), layers.end(), fits))
      throw InputError(file, "", "several pictures",
                       "the name of one layer (--layer of sturm compare, --picture-layer of sturm see, \"layer\" of an "
                       "environment): " +
                           list_of(layers));
  }
  throw InputError(file, "", "no channels R, G and B, and no luminance Y",
                   "a picture; the layers are " + list_of(layers));
}

const ExrLayer* depth_layer_of(const std::vector<ExrLayer>& layers) {
  const ExrLayer* found = nullptr;
  for (const ExrLayer& layer : layers) {
    if (layer.channels.size() != 1 || is_picture(layer)) continue;
    if (layer.name == "depth" || layer.name == "Z") return &layer;
    if (!found && (means_depth(layer.name) || means_depth(channel_layer(layer.channels.front())))) found = &layer;
  }
  return found;
}

}  // namespace sturm
