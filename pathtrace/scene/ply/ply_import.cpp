#include "pathtrace/scene/ply/ply_import.h"

#include <algorithm>
#include <utility>

#include "io/files/error.h"
#include "pathtrace/scene/lost_precision.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/model_placement.h"
#include "pathtrace/scene/named_files.h"
#include "pathtrace/scene/placed_position.h"
#include "pathtrace/scene/ply/ply_model.h"
#include "pathtrace/scene/texture_file.h"
#include "pathtrace/scene/unstated_reflectance.h"
#include "pathtrace/scene/vertex_colours.h"
#include "pathtrace/scene/vertex_normals.h"

namespace sturm {
namespace {

class PlyImport {
 public:
  explicit PlyImport(const ModelSpec& spec) : spec_(spec), placement_(spec), model_(read_ply(spec.file)) {}

  SceneDescription run() {
    if (model_.triangles.empty())
      throw InputError(spec_.file.string(), "", "no triangles", "a model with at least one triangle");
    for (const std::string& what : model_.left_out) note(what + " are left out");
    if (!model_.corner_coordinates.empty()) part_corners();
    mesh_.name = spec_.file.stem().string();
    mesh_.triangles = std::move(model_.triangles);
    mesh_.texture_coordinates = std::move(model_.texture_coordinates);
    add_positions();
    add_normals();
    add_colours();
    add_material();
    result_.meshes.push_back(std::move(mesh_));
    return std::move(result_);
  }

 private:
  void note(const std::string& text) { result_.notes.push_back(spec_.file.filename().string() + ": " + text); }

  /// Texture coordinates that are stated with the faces: every triangle gets vertices of its own.
  void part_corners() {
    std::vector<std::uint32_t> from;
    model_.texture_coordinates.clear();
    for (std::size_t i = 0; i < model_.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        from.push_back(std::exchange(model_.triangles[i][k], static_cast<std::uint32_t>(from.size())));
        model_.texture_coordinates.push_back(model_.corner_coordinates[i][k]);
      }
    const auto part = [&](auto& values) {
      if (values.empty()) return;
      auto parted = values;
      parted.clear();
      parted.reserve(from.size());
      for (const std::uint32_t vertex : from) parted.push_back(values[vertex]);
      values = std::move(parted);
    };
    part(model_.positions);
    part(model_.normals);
    part(model_.colours);
  }

  void add_positions() {
    mesh_.positions.reserve(model_.positions.size());
    for (const Eigen::Vector3d& position : model_.positions)
      mesh_.positions.push_back(placed_position(placement_, position, spec_.file, mesh_.name));
    double largest = largest_coordinate_of(mesh_);
    if (model_.rounded)
      for (const Eigen::Vector3d& position : model_.positions)
        largest = std::max(largest, placement_.scale() * position.cwiseAbs().maxCoeff());
    if (const std::string lost = lost_precision(mesh_, largest); !lost.empty()) note(lost);
  }

  void add_normals() {
    std::vector<Eigen::Vector3d> normals;
    normals.reserve(model_.normals.size());
    for (const Eigen::Vector3f& normal : model_.normals) normals.push_back(placement_.turn() * normal.cast<double>());
    mesh_.normals = normals_that_bend(normals, mesh_);
  }

  void add_colours() {
    if (model_.colours.empty()) return;
    note(decode_stated_colours(model_.colours, spec_.texture_encoding, spec_.file));
    mesh_.vertex_colours.reserve(model_.colours.size());
    for (const Eigen::Vector3f& colour : model_.colours) mesh_.vertex_colours.push_back(colour.homogeneous());
  }

  void add_material() {
    Material material;
    material.name = "DefaultMaterial";
    material.nearest_filter = spec_.texture_filter == TextureFilter::Nearest;
    material.albedo_mapping.wrap_u = material.albedo_mapping.wrap_v = spec_.texture_wrap.value_or(TextureWrap::Clamp);
    if (!mesh_.texture_coordinates.empty() && !model_.textures.empty())
      material.albedo_texture = texture(model_.textures.front());
    for (std::size_t i = material.albedo_texture ? 1 : 0; i < model_.textures.size(); ++i)
      note("texture " + in_quotes(model_.textures[i]) + " is left out");
    material.albedo.setConstant(material.albedo_texture || !mesh_.vertex_colours.empty() ? 1.0f : unstated_reflectance);
    result_.materials.push_back(std::move(material));
  }

  std::shared_ptr<const Image> texture(const std::string& name) {
    const NamedFiles files({spec_.file.parent_path()});
    const auto found = files.find(name);
    if (!found)
      throw InputError(spec_.file.string(), "comment TextureFile", in_quotes(files.expected(name).string()),
                       "a texture file that exists");
    if (found->elsewhere) note(in_quotes(name) + " does not exist; " + found->file.string() + " is taken");
    std::vector<std::string> notes;
    const Image picture = read_texture(found->file, spec_.texture_encoding, StatedIn::Picture, notes);
    for (const std::string& text : notes) note(text);
    return colours_of(picture);
  }

  const ModelSpec& spec_;
  ModelPlacement placement_;
  PlyModel model_;
  Mesh mesh_;
  SceneDescription result_;
};

}  // namespace

SceneDescription import_ply(const ModelSpec& spec) {
  return PlyImport(spec).run();
}

}  // namespace sturm
