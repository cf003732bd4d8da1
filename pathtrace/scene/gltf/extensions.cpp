#include "pathtrace/scene/gltf/extensions.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "io/files/error.h"
#include "pathtrace/scene/gltf/members.h"

namespace sturm::gltf {

namespace {

enum class Taken {
  whole,    ///< read
  in_part,  ///< read as the text says
  without,  ///< left out; the scene is right but for what the extension adds
  never     ///< a file that requires it cannot be shown; one that merely uses it has a plain form, which is shown
};

struct Extension {
  std::string_view name;
  Taken taken;
  std::string_view what;  ///< what it adds
};

constexpr Extension extensions[] = {
    {"KHR_texture_transform", Taken::whole, ""},
    {"KHR_materials_emissive_strength", Taken::whole, ""},
    {"KHR_materials_ior", Taken::whole, ""},
    {"KHR_mesh_quantization", Taken::whole, ""},
    {"EXT_mesh_gpu_instancing", Taken::whole, ""},
    {"KHR_node_visibility", Taken::whole, ""},
    {"KHR_materials_unlit", Taken::in_part, "unlit surfaces are taken as Lambert's, which light shows"},
    {"KHR_materials_pbrSpecularGlossiness", Taken::in_part,
     "diffuse colour, its texture and glossiness are taken, the specular colour is left out"},
    {"EXT_texture_webp", Taken::in_part, "the plain picture is taken where there is one"},
    {"KHR_materials_transmission", Taken::without, "transmission"},
    {"KHR_materials_diffuse_transmission", Taken::without, "diffuse transmission"},
    {"KHR_materials_volume", Taken::without, "volume"},
    {"KHR_materials_volume_scatter", Taken::without, "volume scattering"},
    {"KHR_materials_dispersion", Taken::without, "dispersion"},
    {"KHR_materials_clearcoat", Taken::without, "clear coat"},
    {"KHR_materials_sheen", Taken::without, "sheen"},
    {"KHR_materials_specular", Taken::without, "specular"},
    {"KHR_materials_anisotropy", Taken::without, "anisotropy"},
    {"KHR_materials_iridescence", Taken::without, "iridescence"},
    {"KHR_materials_variants", Taken::without, "material variants (the default is taken)"},
    {"KHR_materials_subsurface", Taken::without, "subsurface scattering"},
    {"KHR_lights_punctual", Taken::without, "lights"},
    {"EXT_lights_ies", Taken::without, "lights"},
    {"EXT_lights_image_based", Taken::without, "image-based lights"},
    {"KHR_animation_pointer", Taken::without, "animations"},
    {"KHR_xmp", Taken::without, "metadata"},
    {"KHR_xmp_json_ld", Taken::without, "metadata"},
    {"MSFT_lod", Taken::without, "levels of detail (the finest is taken)"},
    {"KHR_texture_basisu", Taken::never, "KTX2 textures"},
    {"MSFT_texture_dds", Taken::never, "DDS textures"},
    {"KHR_draco_mesh_compression", Taken::never, "Draco compression"},
    {"EXT_meshopt_compression", Taken::never, "meshopt compression"},
    {"KHR_meshopt_compression", Taken::never, "meshopt compression"},
};

const Extension* known(std::string_view name) {
  const auto at =
      std::find_if(std::begin(extensions), std::end(extensions), [&](const Extension& e) { return e.name == name; });
  return at == std::end(extensions) ? nullptr : at;
}

/// The name of a compression that the buffer mentions.
std::optional<std::string> compression(const Json& buffer) {
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    if (extension(buffer, name)) return name;
  return std::nullopt;
}

}  // namespace

void check_required_extensions(const Json& gltf, const Source& root) {
  const Json& required = list(gltf, "extensionsRequired", root);
  for (std::size_t i = 0; i < required.size(); ++i) {
    const Source where = root / "extensionsRequired" / i;
    const Extension* extension = required[i].is_string() ? known(required[i].get<std::string>()) : nullptr;
    if (extension && extension->taken != Taken::never) continue;
    where.fail(required[i], extension ? "a file without " + std::string(extension->what) + ", which is not read"
                                      : "a file that requires no extension but those that are known here");
  }
}

std::vector<std::string> extension_notes(const Json& gltf, const Source& root) {
  std::vector<std::string> notes;
  for (const Json& used : list(gltf, "extensionsUsed", root)) {
    if (!used.is_string()) continue;
    const std::string name = used.get<std::string>();
    const Extension* extension = known(name);
    if (extension && extension->taken == Taken::whole) continue;
    if (!extension)
      notes.push_back("the extension " + name + " is not known and left out");
    else if (extension->taken == Taken::in_part)
      notes.push_back(name + ": " + std::string(extension->what));
    else if (extension->taken == Taken::without)
      notes.push_back(name + " is left out: " + std::string(extension->what));
    else
      notes.push_back(name + " is left out: the plain form of the data is taken in place of " +
                      std::string(extension->what));
  }
  return notes;
}

void refuse_compressed_buffer(const Json& buffer, const Source& where) {
  if (const std::optional<std::string> name = compression(buffer))
    throw InputError(where.file, where.pointer + "/extensions/" + *name, "no bytes but compressed ones",
                     "a file that also holds the plain form of its meshes");
}

std::vector<std::string> extensions_left_out(const Json& material) {
  std::vector<std::string> words;
  const auto all = material.find("extensions");
  if (all == material.end() || !all->is_object()) return words;
  for (const auto& [name, content] : all->items()) {
    const Extension* extension = known(name);
    if (extension && extension->taken == Taken::without) words.emplace_back(extension->what);
  }
  return words;
}

}  // namespace sturm::gltf
