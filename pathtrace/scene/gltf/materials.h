#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "pathtrace/scene/gltf/textures.h"

namespace sturm::gltf {

/// What meshes bring to a material.
struct MaterialUse {
  std::optional<std::size_t> material;  ///< in the file; none: glTF's default
  bool coloured = false;                ///< the mesh has vertex colours
  bool translucent = false;             ///< some of them with an alpha below 1

  auto key() const { return std::tuple(material, coloured, translucent); }
};

/// A material that is in the scene, and which texture coordinates it asks of its meshes.
struct PlacedMaterial {
  int index = 0;                           ///< into SceneDescription::materials
  std::optional<std::size_t> coordinates;  ///< TEXCOORD_n of albedo and opacity
  std::optional<std::size_t> emission_coordinates;
};

/// The materials of a file, built when a mesh first uses them.
///
/// - Metallic-roughness factors → gltf_surface.h; a metal with a texture or vertex colours is tinted by them.
/// - emissiveFactor × KHR_materials_emissive_strength × emissive texture; `doubleSided` emits from both sides.
/// - alphaMode MASK and BLEND → Opacity, with the alpha of factor, texture and vertex colours.
/// - KHR_materials_pbrSpecularGlossiness: its diffuse colour and glossiness; KHR_materials_unlit: Lambert.
class Materials {
 public:
  /// Adds to `scene`: materials, and notes about what is left out of them.
  Materials(const Document& document, const ModelSpec& spec, SceneDescription& scene)
      : document_(document), spec_(spec), textures_(document, spec), scene_(scene) {}

  const PlacedMaterial& placed(const MaterialUse& use);

 private:
  PlacedMaterial build(const MaterialUse& use);
  void take_base(const Json& pbr, const Source& where, const char* colour, const char* picture, Material& material,
                 PlacedMaterial& result);
  void take_opacity(const Json& source, const Source& where, const MaterialUse& use, Material& material);
  void take_emission(const Json& source, const Source& where, Material& material, PlacedMaterial& result);
  void take_surface(const Json& source, const Source& where, bool coloured, Material& material);
  void note_what_is_left_out(const Json& source, const Material& material, const std::string& more);
  void note(const std::string& text);

  const Document& document_;
  const ModelSpec& spec_;
  Textures textures_;
  SceneDescription& scene_;
  std::map<std::tuple<std::optional<std::size_t>, bool, bool>, PlacedMaterial> placed_;
};

}  // namespace sturm::gltf
