#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/specs/scene_spec.h"
#include "pathtrace/scene/obj/mtl_library.h"
#include "pathtrace/scene/obj/mtl_texture.h"
#include "pathtrace/scene/obj/texture_files.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Turns materials of MTL files into those of a scene.
///
/// - `Kd` → albedo (0.6 where neither it nor `map_Kd` is stated; 1 under a texture), `map_Kd` → its texture, `Ke` and
///   `map_Ke` → emission, `d`, `Tr` and `map_d` → the share of rays that the surface stops.
/// - One number stands for all three of a colour.
/// - Everything else is left out. What would change the picture is noted.
class ObjMaterials {
 public:
  explicit ObjMaterials(const ModelSpec& spec) : spec_(spec) {}

  /// Loads textures. Throws InputError that names the model, the line of the MTL file and the material.
  Material material(const MtlMaterial& source);

  /// For faces without a material, or with one that nothing defines.
  Material plain(const std::string& name) const;

  /// What is left out or taken otherwise; in words, without the file's name.
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& notes_about_pictures() const { return files_.notes(); }

 private:
  [[noreturn]] void fail(const MtlMaterial& source, const std::string& what, const std::string& value,
                         const std::string& expected) const;
  std::optional<Eigen::Vector3d> colour(const MtlMaterial& source, const char* word, const std::string& shown) const;
  std::optional<MtlTexture> texture(const MtlMaterial& source, const char* word, const std::string& shown);
  TextureMapping mapping(const MtlMaterial& source, const MtlTexture& texture);
  void take_colours(const MtlMaterial& source, Material& material);
  void take_emission(const MtlMaterial& source, Material& material);
  void take_opacity(const MtlMaterial& source, Material& material);
  std::optional<double> stated_opacity(const MtlMaterial& source);
  void note_what_is_left_out(const MtlMaterial& source, const Material& material);
  void note(const MtlMaterial& source, const std::string& text);

  const ModelSpec& spec_;
  TextureFiles files_;
  std::vector<std::string> notes_;
};

}  // namespace sturm
