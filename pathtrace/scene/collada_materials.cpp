#include "pathtrace/scene/collada_materials.h"

#include <algorithm>
#include <string_view>

#include "io/files/text_file.h"
#include "pathtrace/scene/xml_tags.h"

namespace sturm {
namespace {

constexpr std::string_view xml_blanks = " \t\r\n";

/// "0 0 0 1", which has an alpha.
bool is_black(std::string_view colour) {
  int numbers = 0;
  bool in_number = false, zero = true;
  for (const char c : colour) {
    const bool blank = xml_blanks.find(c) != std::string_view::npos;
    if (!blank && !in_number) ++numbers;
    in_number = !blank;
    if (in_number && numbers <= 3 && c >= '1' && c <= '9') zero = false;
  }
  return zero;
}

/// How a texture goes on beyond its border; COLLADA's default is WRAP.
struct Sampler {
  TextureWrap u = TextureWrap::Repeat, v = TextureWrap::Repeat;
  bool has_border = false;

  void state(bool along_u, std::string_view word) {
    word.remove_prefix(std::min(word.find_first_not_of(xml_blanks), word.size()));
    TextureWrap& wrap = along_u ? u : v;
    wrap = word.starts_with("WRAP")     ? TextureWrap::Repeat
           : word.starts_with("MIRROR") ? TextureWrap::Mirror
                                        : TextureWrap::Clamp;
    has_border = has_border || word.starts_with("BORDER") || word.starts_with("NONE");
  }
};

/// The effects of a file by their ids, tag after tag.
class Effects {
 public:
  explicit Effects(std::string_view text) {
    for (XmlTags tags(text); tags.next();) {
      const std::string_view name = tags.name();
      if (name == "effect") begin(tags.attribute("id"));
      if (name == "/effect") end();
      if (name == "newparam") parameter_ = tags.attribute("sid");
      if (name == "wrap_s" || name == "wrap_t") samplers_[parameter_].state(name == "wrap_s", tags.content());
      if (name == "constant") effect_.is_constant = true;
      if (name == "phong" || name == "blinn") has_highlights_ = true;
      if (name == "/phong" || name == "/blinn") has_highlights_ = false;
      if (name == "diffuse" || name == "specular") part_ = name;
      if (name == "/diffuse" || name == "/specular") part_ = "";
      if (part_ == "diffuse") read_diffuse(tags);
      if (part_ == "specular" && has_highlights_) read_specular(tags);
    }
  }

  const ColladaMaterial* find(const std::string& id) const {
    const auto at = effects_.find(id);
    return at == effects_.end() ? nullptr : &at->second;
  }

 private:
  void begin(const std::string& id) {
    id_ = id;
    effect_ = {};
    samplers_.clear();
    texture_.clear();
  }

  void end() {
    if (const auto sampler = samplers_.find(texture_); sampler != samplers_.end()) {
      effect_.wrap_u = sampler->second.u;
      effect_.wrap_v = sampler->second.v;
      effect_.has_border = sampler->second.has_border;
    }
    effects_[id_] = effect_;
  }

  void read_diffuse(const XmlTags& tags) {
    if (tags.name() == "texture") texture_ = tags.attribute("texture");
    if (tags.name() == "param") effect_.has_parameter = true;
  }

  void read_specular(const XmlTags& tags) {
    const std::string_view name = tags.name();
    if (name == "texture" || name == "param" || (name == "color" && !is_black(tags.content())))
      effect_.has_specular = true;
  }

  std::map<std::string, ColladaMaterial> effects_;
  std::string id_, parameter_, texture_, part_;
  std::map<std::string, Sampler> samplers_;
  ColladaMaterial effect_;
  bool has_highlights_ = false;
};

}  // namespace

std::map<std::string, ColladaMaterial> collada_materials(const std::filesystem::path& file) {
  const std::string text = file_contents(file).value_or("");
  const Effects effects(text);
  std::map<std::string, ColladaMaterial> materials;
  std::string id, name;
  for (XmlTags tags(text); tags.next();) {
    if (tags.name() == "material") {
      id = tags.attribute("id");
      name = tags.attribute("name");
    }
    if (tags.name() != "instance_effect") continue;
    const std::string url = tags.attribute("url");
    if (!url.starts_with('#')) continue;
    if (const ColladaMaterial* effect = effects.find(url.substr(1))) materials[id] = materials[name] = *effect;
  }
  return materials;
}

}  // namespace sturm
