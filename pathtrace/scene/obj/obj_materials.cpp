#include "pathtrace/scene/obj/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/files/error.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/obj/obj_words.h"
#include "pathtrace/scene/unstated_reflectance.h"

namespace sturm {
namespace {

/// The numbers at the start of a text.
std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
    const auto number = number_of(word);
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Whether a statement says something else than `nothing`, the number at which it has no effect.
bool says_more_than(const MtlStatement* statement, double nothing) {
  if (!statement) return false;
  const std::vector<double> numbers = numbers_of(statement->text);
  return numbers.empty() || std::any_of(numbers.begin(), numbers.end(), [&](double n) { return n != nothing; });
}

/// Models of illumination without highlights: colour alone, and Lambert's.
bool has_highlights(const MtlMaterial& source) {
  const MtlStatement* model = source.find("illum");
  const std::vector<double> number = model ? numbers_of(model->text) : std::vector<double>{};
  return number.empty() || (number[0] != 0.0 && number[0] != 1.0);
}

struct MapLeftOut {
  const char *word, *other_word, *name;
};

constexpr MapLeftOut maps_left_out[] = {
    {"norm", "map_kn", "normal map"},         {"bump", "map_bump", "bump map"},
    {"map_ks", nullptr, "specular texture"},  {"disp", "map_disp", "displacement"},
    {"map_pr", nullptr, "roughness texture"}, {"map_pm", nullptr, "metallic texture"},
    {"map_ps", nullptr, "sheen texture"},     {"map_tr", nullptr, "transparency texture"},
    {"refl", "map_refl", "reflection map"},   {"decal", nullptr, "decal"}};

}  // namespace

void ObjMaterials::fail(const MtlMaterial& source, const std::string& what, const std::string& value,
                        const std::string& expected) const {
  throw InputError(spec_.file.string(), what + " of material " + in_quotes(source.name), value, expected);
}

void ObjMaterials::note(const MtlMaterial& source, const std::string& text) {
  notes_.push_back("material " + in_quotes(source.name) + text);
}

std::optional<Eigen::Vector3d> ObjMaterials::colour(const MtlMaterial& source, const char* word,
                                                    const std::string& shown) const {
  const MtlStatement* statement = source.find(word);
  if (!statement) return std::nullopt;
  const std::string_view text = without_comment(statement->text);
  const std::vector<double> numbers = numbers_of(text);
  const bool is_finite = std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
  if (is_finite && numbers.size() == 1) return Eigen::Vector3d::Constant(numbers[0]);
  if (is_finite && (numbers.size() == 3 || numbers.size() == 4)) return Eigen::Vector3d(numbers.data());
  fail(source, statement->place + ", " + shown, in_quotes(text), "one number, or three: red, green, blue");
}

std::optional<MtlTexture> ObjMaterials::texture(const MtlMaterial& source, const char* word, const std::string& shown) {
  const MtlStatement* statement = source.find(word);
  if (!statement || without_comment(statement->text).empty()) return std::nullopt;
  const NamedFiles files({source.defined_in.parent_path(), spec_.file.parent_path()});
  MtlTexture texture = read_mtl_texture(statement->text, files);
  if (!texture.found)
    fail(source, statement->place + ", " + shown, in_quotes(files.expected(texture.name).string()),
         "a texture file that exists, beside the MTL file or beside the model");
  if (texture.found->elsewhere)
    note(source, ": " + in_quotes(texture.name) + " does not exist; " + texture.found->file.string() + " is taken");
  for (const std::string& option : texture.left_out)
    note(source, ": option " + option + " of its texture " + shown + " is left out");
  return texture;
}

TextureMapping ObjMaterials::mapping(const MtlMaterial& source, const MtlTexture& texture) {
  TextureMapping mapping;
  mapping.picture_from_mesh << texture.scale.x(), 0.0f, texture.offset.x(), 0.0f, texture.scale.y(), texture.offset.y();
  // The format's own default is to repeat; where nothing is scaled or moved, models mostly mean the picture as a whole.
  const bool moved = texture.scale != Eigen::Vector2f::Ones() || texture.offset != Eigen::Vector2f::Zero();
  TextureWrap wrap = spec_.texture_wrap.value_or(moved ? TextureWrap::Repeat : TextureWrap::Clamp);
  if (texture.clamped) {
    const TextureWrap stated = *texture.clamped ? TextureWrap::Clamp : TextureWrap::Repeat;
    if (spec_.texture_wrap && *spec_.texture_wrap != stated)
      note(source, std::string(": -clamp ") + (*texture.clamped ? "on" : "off") +
                       " of its texture counts, not the model's texture_wrap");
    wrap = stated;
  }
  mapping.wrap_u = mapping.wrap_v = wrap;
  return mapping;
}

void ObjMaterials::take_colours(const MtlMaterial& source, Material& material) {
  const std::optional<MtlTexture> map = texture(source, "map_kd", "map_Kd");
  const auto stated = colour(source, "kd", "Kd");
  material.albedo =
      stated ? Eigen::Vector3f(stated->cast<float>()) : Eigen::Vector3f::Constant(map ? 1.0f : unstated_reflectance);
  for (int k = 0; k < 3; ++k)
    if (!(material.albedo[k] >= 0.0f && material.albedo[k] <= 1.0f))
      fail(source, source.find("kd")->place + ", Kd", exact_number((*stated)[k]), "reflectances from 0 to 1");
  if (!map) return;
  material.albedo_texture = files_.colours(map->found->file, spec_.texture_encoding);
  material.albedo_mapping = mapping(source, *map);
  if (map->channel) note(source, ": option -imfchan of its texture map_Kd is left out");
}

void ObjMaterials::take_emission(const MtlMaterial& source, Material& material) {
  const auto stated = colour(source, "ke", "Ke");
  const bool has_map = source.find("map_ke") && (!stated || !stated->isZero(0.0));
  if (!stated && !has_map) return;
  material.emission = stated ? Eigen::Vector3f(stated->cast<float>()) : Eigen::Vector3f(Eigen::Vector3f::Ones());
  for (int k = 0; k < 3; ++k)
    if (!(material.emission[k] >= 0.0f && std::isfinite(material.emission[k])))
      fail(source, source.find("ke")->place + ", Ke", exact_number((*stated)[k]), "a finite radiance of at least 0");
  const std::optional<MtlTexture> map = has_map ? texture(source, "map_ke", "map_Ke") : std::nullopt;
  if (!map) return;
  material.emission_texture = files_.colours(map->found->file, spec_.texture_encoding);
  material.emission_mapping = mapping(source, *map);
}

/// `d`, else 1 − `Tr`. Some programs write Tr 1 where nothing is transparent.
std::optional<double> ObjMaterials::stated_opacity(const MtlMaterial& source) {
  for (const char* word : {"d", "tr"}) {
    const MtlStatement* statement = source.find(word);
    if (!statement) continue;
    std::string_view text = statement->text;
    if (std::string_view ahead = text; lower_case(take_word(ahead)) == "-halo") {
      note(source, ": option -halo of d is left out");
      text = ahead;
    }
    const std::vector<double> numbers = numbers_of(text);
    if (numbers.empty() || !(numbers[0] >= 0.0 && numbers[0] <= 1.0))
      fail(source, statement->place + ", " + (word[0] == 'd' ? "d" : "Tr"), in_quotes(text), "a number from 0 to 1");
    if (word[0] == 'd') return numbers[0];
    if (numbers[0] != 1.0) return 1.0 - numbers[0];
    note(source, ": Tr 1 without d is taken as opaque");
  }
  return std::nullopt;
}

void ObjMaterials::take_opacity(const MtlMaterial& source, Material& material) {
  const double factor = stated_opacity(source).value_or(1.0);
  const std::optional<MtlTexture> map = texture(source, "map_d", "map_d");
  if (factor < 1.0)
    note(source,
         ": its transparency (opacity " + exact_number(factor) + ") lets rays pass straight on, without refraction");
  if (factor >= 1.0 && !map) return;
  material.opacity.mode = Opacity::Mode::blend;
  material.opacity.factor = static_cast<float>(factor);
  if (!map) return;
  material.opacity.texture = files_.channel(map->found->file, map->channel);
  material.opacity.mapping = mapping(source, *map);
}

void ObjMaterials::note_what_is_left_out(const MtlMaterial& source, const Material& material) {
  std::string left_out;
  const auto add = [&](bool is_there, const char* what) {
    if (is_there) left_out += (left_out.empty() ? "" : ", ") + std::string(what);
  };
  add(says_more_than(source.find("pm"), 0.0), "metallic");
  add(has_highlights(source) && says_more_than(source.find("ks"), 0.0), "specular");
  add(says_more_than(source.find("ps"), 0.0), "sheen");
  add(says_more_than(source.find("pc"), 0.0), "clear coat");
  add(says_more_than(source.find("aniso"), 0.0), "anisotropy");
  add(is_cut_out(material) && says_more_than(source.find("tf"), 1.0), "transmission filter");
  for (const MapLeftOut& map : maps_left_out)
    add(source.find(map.word) || (map.other_word && source.find(map.other_word)), map.name);
  if (!left_out.empty()) note(source, " is taken as Lambert without its " + left_out);
}

Material ObjMaterials::material(const MtlMaterial& source) {
  Material material;
  material.name = source.name;
  material.nearest_filter = spec_.texture_filter == TextureFilter::Nearest;
  take_colours(source, material);
  take_emission(source, material);
  take_opacity(source, material);
  note_what_is_left_out(source, material);
  return material;
}

Material ObjMaterials::plain(const std::string& name) const {
  Material material;
  material.name = name;
  material.albedo.setConstant(unstated_reflectance);
  return material;
}

}  // namespace sturm
