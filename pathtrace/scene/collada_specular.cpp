#include "pathtrace/scene/collada_specular.h"

#include "io/files/text_file.h"
#include "pathtrace/scene/xml_tags.h"

namespace sturm {
namespace {

/// "0 0 0 1", which has an alpha.
bool is_black(std::string_view colour) {
  int numbers = 0;
  bool in_number = false, zero = true;
  for (const char c : colour) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank && !in_number) ++numbers;
    in_number = !blank;
    if (in_number && numbers <= 3 && c >= '1' && c <= '9') zero = false;
  }
  return zero;
}

/// Ids of the effects with a specular part.
std::set<std::string> effects_with_specular(std::string_view text) {
  std::set<std::string> found;
  std::string effect;
  bool has_highlights = false, in_specular = false;
  for (XmlTags tags(text); tags.next();) {
    const std::string_view name = tags.name();
    if (name == "effect") effect = tags.attribute("id");
    if (name == "phong" || name == "blinn") has_highlights = true;
    if (name == "/phong" || name == "/blinn") has_highlights = false;
    if (name == "specular" || name == "/specular") in_specular = name[0] != '/' && has_highlights;
    if (!in_specular) continue;
    if (name == "texture" || name == "param" || (name == "color" && !is_black(tags.content()))) found.insert(effect);
  }
  return found;
}

}  // namespace

std::set<std::string> collada_materials_with_specular(const std::filesystem::path& file) {
  const std::string text = file_contents(file).value_or("");
  const std::set<std::string> effects = effects_with_specular(text);
  std::set<std::string> materials;
  std::string id, name;
  for (XmlTags tags(text); tags.next();) {
    if (tags.name() == "material") {
      id = tags.attribute("id");
      name = tags.attribute("name");
    }
    if (tags.name() != "instance_effect") continue;
    const std::string url = tags.attribute("url");
    if (!url.starts_with('#') || !effects.contains(url.substr(1))) continue;
    materials.insert(id);
    materials.insert(name);
  }
  return materials;
}

}  // namespace sturm
