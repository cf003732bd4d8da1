#include "pathtrace/scene/obj/obj_import.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "io/files/error.h"
#include "pathtrace/scene/lost_precision.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/model_placement.h"
#include "pathtrace/scene/obj/corner_numbers.h"
#include "pathtrace/scene/obj/mtl_library.h"
#include "pathtrace/scene/obj/obj_materials.h"
#include "pathtrace/scene/obj/obj_model.h"
#include "pathtrace/scene/obj/obj_words.h"
#include "pathtrace/scene/placed_position.h"
#include "pathtrace/scene/vertex_colours.h"
#include "pathtrace/scene/vertex_normals.h"

namespace sturm {
namespace {

using Eigen::Vector3f;

class ObjImport {
 public:
  explicit ObjImport(const ModelSpec& spec)
      : spec_(spec), placement_(spec), model_(read_obj(spec.file)), materials_(spec) {}

  SceneDescription run() {
    if (std::all_of(model_.parts.begin(), model_.parts.end(), [](const auto& part) { return part.triangles.empty(); }))
      fail("", "no triangles", "a model with at least one triangle");
    read_libraries();
    for (const std::string& what : model_.left_out) note(what + " are left out");
    if (!model_.colours.empty()) note(decode_stated_colours(model_.colours, spec_.texture_encoding, spec_.file));
    CornerNumbers numbers(model_.positions.size());
    for (const ObjModel::Part& part : model_.parts) add_mesh(part, numbers);
    for (const std::string& text : materials_.notes()) note(text);
    for (const std::string& text : materials_.notes_about_pictures()) note(text);
    note_coordinates_beyond();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& value, const std::string& expected) const {
    throw InputError(spec_.file.string(), where, value, expected);
  }

  std::string place(long line) const { return spec_.file.string() + ":" + std::to_string(line); }

  void note(const std::string& text) { result_.notes.push_back(spec_.file.filename().string() + ": " + text); }

  void add_library(const std::filesystem::path& file) {
    for (MtlMaterial& material : read_mtl(file)) library_.push_back(std::move(material));
  }

  /// One name with blanks in it, or several names: of what is left each time the longest that is a file.
  void read_libraries() {
    const NamedFiles files({spec_.file.parent_path()});
    for (const ObjModel::LibraryUse& use : model_.libraries) {
      std::string_view rest = without_comment(use.names);
      if (const auto whole = files.find(use.names)) {
        add_library(whole->file);
        continue;
      }
      while (!rest.empty()) {
        std::string_view name = rest;
        std::optional<NamedFiles::Found> found;
        while (!(found = files.find(name))) {
          const std::size_t blank = name.find_last_of(" \t");
          if (blank == std::string_view::npos)
            throw InputError(place(use.line), "mtllib", in_quotes(files.expected(name).string()),
                             "a material library that exists and can be read");
          name = trimmed(name.substr(0, blank));
        }
        add_library(found->file);
        rest = trimmed(rest.substr(name.size()));
      }
    }
  }

  Material made_material(int use) {
    if (use < 0) {
      Material plain = materials_.plain("DefaultMaterial");
      if (!model_.colours.empty()) plain.albedo.setOnes();
      return plain;
    }
    const auto& [name, line] = model_.used_materials[static_cast<std::size_t>(use)];
    if (const MtlMaterial* source = find_material(library_, name)) return materials_.material(*source);
    if (!model_.libraries.empty())
      throw InputError(place(line), "usemtl", in_quotes(name), "a material that a library of the file defines");
    note("line " + std::to_string(line) + ": material " + in_quotes(name) +
         " is not defined, since the file names no library; it is taken as grey with a reflectance of 0.6");
    return materials_.plain(name);
  }

  /// The number of a material in the description; of the use −1, that of faces before any `usemtl`.
  int material_of(int use) {
    std::optional<int>& known = numbers_of_uses_[use];
    if (!known) {
      known = static_cast<int>(result_.materials.size());
      result_.materials.push_back(made_material(use));
    }
    return *known;
  }

  static void add_name(Mesh& mesh, std::string_view name) {
    if (name.empty() || name == mesh.name) return;
    if (std::find(mesh.also_named.begin(), mesh.also_named.end(), name) == mesh.also_named.end())
      mesh.also_named.emplace_back(name);
  }

  Mesh named_mesh(const ObjModel::Part& part) {
    Mesh mesh;
    mesh.name = !part.groups.empty() ? part.groups : !part.object.empty() ? part.object : "defaultobject";
    add_name(mesh, part.object);
    std::string_view groups = part.groups;
    for (std::string_view group = take_word(groups); !group.empty(); group = take_word(groups)) add_name(mesh, group);
    mesh.material = material_of(part.material);
    return mesh;
  }

  void add_mesh(const ObjModel::Part& part, CornerNumbers& numbers) {
    if (part.triangles.empty()) return;
    Mesh mesh = named_mesh(part);
    std::vector<ObjModel::Corner> corners;
    numbers.begin_mesh();
    mesh.triangles.reserve(part.triangles.size());
    for (const auto& triangle : part.triangles) {
      std::array<std::uint32_t, 3>& shared = mesh.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        ObjModel::Corner corner = triangle[k];
        if (!part.has_texture) corner.texture = ObjModel::none;
        if (!part.has_normals) corner.normal = ObjModel::none;
        shared[k] = numbers.number(corner, corners);
      }
    }
    add_positions(mesh, corners);
    if (part.has_texture) {
      mesh.texture_coordinates.reserve(corners.size());
      for (const auto& corner : corners) mesh.texture_coordinates.push_back(model_.texture_coordinates[corner.texture]);
    }
    if (part.has_normals) add_normals(mesh, corners);
    if (!model_.colours.empty())
      for (const auto& corner : corners) mesh.vertex_colours.push_back(model_.colours[corner.position].homogeneous());
    result_.meshes.push_back(std::move(mesh));
  }

  void add_positions(Mesh& mesh, const std::vector<ObjModel::Corner>& corners) {
    mesh.positions.reserve(corners.size());
    for (const auto& corner : corners)
      mesh.positions.push_back(placed_position(placement_, model_.positions[corner.position], spec_.file, mesh.name));
    if (const std::string lost = lost_precision(mesh, largest_coordinate_of(mesh)); !lost.empty()) note(lost);
  }

  void add_normals(Mesh& mesh, const std::vector<ObjModel::Corner>& corners) const {
    std::vector<Eigen::Vector3d> normals;
    normals.reserve(corners.size());
    for (const auto& corner : corners)
      normals.push_back(placement_.turn() * model_.normals[corner.normal].cast<double>());
    mesh.normals = normals_that_bend(normals, mesh);
  }

  /// Whoever tiles a texture finds its border smeared unless the scene says otherwise.
  void note_coordinates_beyond() {
    if (spec_.texture_wrap) return;
    std::vector<bool> noted(result_.materials.size(), false);
    for (const Mesh& mesh : result_.meshes) {
      const auto number = static_cast<std::size_t>(mesh.material);
      const Material& material = result_.materials[number];
      if (noted[number] || !material.albedo_texture || material.albedo_mapping.wrap_u != TextureWrap::Clamp) continue;
      noted[number] = std::any_of(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end(),
                                  [](const auto& uv) { return uv.minCoeff() < -1e-3f || uv.maxCoeff() > 1.001f; });
      if (noted[number])
        note("material " + in_quotes(material.name) +
             ": texture coordinates outside of 0 to 1 show the border of its texture; texture_wrap can repeat it");
    }
  }

  const ModelSpec& spec_;
  ModelPlacement placement_;
  ObjModel model_;
  ObjMaterials materials_;
  std::vector<MtlMaterial> library_;
  std::map<int, std::optional<int>> numbers_of_uses_;
  SceneDescription result_;
};

}  // namespace

SceneDescription import_obj(const ModelSpec& spec) {
  return ObjImport(spec).run();
}

}  // namespace sturm
