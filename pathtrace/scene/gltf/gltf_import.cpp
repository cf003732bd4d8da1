#include "pathtrace/scene/gltf/gltf_import.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "io/files/error.h"
#include "pathtrace/scene/gltf/extensions.h"
#include "pathtrace/scene/gltf/members.h"
#include "pathtrace/scene/gltf/nodes.h"
#include "pathtrace/scene/gltf/primitive.h"
#include "pathtrace/scene/lost_precision.h"
#include "pathtrace/scene/model_placement.h"
#include "pathtrace/scene/vertex_normals.h"

namespace sturm {

namespace {

using namespace gltf;

constexpr std::size_t most_vertices = std::size_t{1} << 27;  // few bytes of a file can ask for many copies

class GltfImport {
 public:
  explicit GltfImport(const ModelSpec& spec)
      : model_(spec),
        document_(spec.file),
        materials_(document_, spec, result_),
        reader_(document_, materials_, result_.notes),
        meshes_(list(document_.json(), "meshes", document_.root())) {}

  SceneDescription run() {
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      if (!meshes_[i].is_object()) (document_.root() / "meshes" / i).fail(meshes_[i], "an object");
    const std::vector<std::string> of_extensions = extension_notes(document_.json(), document_.root());
    nodes_ = nodes_of(document_, result_.notes);
    find_placements();
    for (const Placement& placement : placements_) place(placement);
    for (const std::string& text : of_extensions) note(text);
    note_what_is_left_out();
    if (result_.meshes.empty() && result_.instances.empty())
      throw InputError(document_.file().string(), "", "no triangles", "a model with at least one triangle");
    return std::move(result_);
  }

 private:
  /// A mesh at a place.
  struct Placement {
    std::size_t mesh;
    Eigen::Affine3d world_from_mesh;
    std::vector<double> weights;      ///< of morph targets
    std::optional<std::size_t> skin;  ///< then the joints say where it is
  };
  using Shape = std::pair<std::size_t, std::vector<double>>;  // a mesh and its weights

  void find_placements() {
    for (const std::size_t node : nodes_.shown) {
      const Json& source = document_.json()["nodes"][node];
      const Source where = document_.root() / "nodes" / node;
      const auto mesh = index(source, "mesh", where, meshes_.size(), "mesh");
      if (!mesh) continue;
      const auto skin = index(source, "skin", where, list(document_.json(), "skins", document_.root()).size(), "skin");
      const std::vector<double> weights = source.contains("weights")
                                              ? weights_of(source, where)
                                              : weights_of(meshes_[*mesh], document_.root() / "meshes" / *mesh);
      for (const Eigen::Affine3d& world_from_mesh : places_of(document_, node, nodes_.world_from_node[node])) {
        placements_.push_back({*mesh, world_from_mesh, weights, skin});
        ++shown_[{*mesh, weights}];
      }
    }
  }

  static std::vector<double> weights_of(const Json& parent, const Source& where) {
    const Json& source = list(parent, "weights", where);
    return reals(parent, "weights", where, std::vector<double>(source.size(), 0.0));
  }

  void place(const Placement& placement) {
    const Source where = document_.root() / "meshes" / placement.mesh;
    const std::size_t primitives = list(meshes_[placement.mesh], "primitives", where).size();
    const Shape shape{placement.mesh, placement.weights};
    for (std::size_t i = 0; i < primitives; ++i) {
      const std::pair<Shape, std::size_t> key{shape, i};
      if (const auto known = prototype_of_.find(key); known != prototype_of_.end() && can_instance(placement)) {
        add_instance(known->second, placement);
        continue;
      }
      const auto primitive = reader_.read({placement.mesh, i, placement.weights, placement.skin.has_value()});
      if (!primitive) continue;
      const bool emits =
          result_.materials[static_cast<std::size_t>(primitive->material.index)].emission.maxCoeff() > 0.0f;
      if (shown_[shape] < 2 || emits || !can_instance(placement)) {
        result_.meshes.push_back(placed(*primitive, placement, model_.scene_from_file()));
        note_lost_precision(*primitive, placement.world_from_mesh.linear(), result_.meshes.back());
        continue;
      }
      prototype_of_[key] = static_cast<int>(result_.prototypes.size());
      result_.prototypes.push_back(placed(*primitive, {placement.mesh, Eigen::Affine3d::Identity(), {}, std::nullopt},
                                          Eigen::Affine3d(Eigen::Scaling(model_.scale()))));
      note_lost_precision(*primitive, Eigen::Matrix3d::Identity(), result_.prototypes.back());
      add_instance(prototype_of_[key], placement);
    }
  }

  /// Flattened copies and skinned ones are meshes of their own.
  static bool can_instance(const Placement& placement) {
    const Eigen::Matrix3d turn = placement.world_from_mesh.linear();
    return !placement.skin && std::abs(turn.determinant()) > 1e-5 * turn.colwise().norm().prod();
  }

  void add_instance(int prototype, const Placement& placement) {
    Instance instance{prototype, {}};  // the prototype's positions are scaled already
    instance.world_from_prototype.leftCols<3>() = (model_.turn() * placement.world_from_mesh.linear()).cast<float>();
    instance.world_from_prototype.col(3) = model_.point(placement.world_from_mesh.translation()).cast<float>();
    if (!instance.world_from_prototype.allFinite())
      throw InputError(document_.file().string(),
                       "mesh \"" + result_.prototypes[static_cast<std::size_t>(prototype)].name + "\"",
                       "a transformation that is not finite", "finite transformations");
    result_.instances.push_back(instance);
  }

  /// Positions are single precision in the file; the matrices of nodes are double.
  void note_lost_precision(const Primitive& primitive, const Eigen::Matrix3d& linear, const Mesh& mesh) {
    double largest = largest_coordinate_of(mesh);
    for (const Eigen::Vector3f& p : primitive.positions)
      largest = std::max(largest, model_.scale() * (linear * p.cast<double>()).cwiseAbs().maxCoeff());
    if (const std::string lost = lost_precision(mesh, largest); !lost.empty()) note(lost);
  }

  Mesh placed(const Primitive& primitive, const Placement& placement, const Eigen::Affine3d& scene_from_file) {
    if ((vertices_ += primitive.positions.size()) > most_vertices)
      throw InputError(document_.file().string(), "mesh \"" + primitive.name + "\"",
                       "more than 2^27 vertices up to here", "fewer, copies of a mesh included");
    Mesh mesh;
    mesh.name = primitive.name;
    mesh.material = primitive.material.index;
    mesh.triangles = primitive.triangles;
    mesh.texture_coordinates = primitive.coordinates;
    mesh.emission_coordinates = primitive.emission_coordinates;
    mesh.vertex_colours = primitive.colours;
    mesh.positions.reserve(primitive.positions.size());
    std::vector<Eigen::Vector3d> normals;
    std::vector<Eigen::Affine3d> joints;
    if (placement.skin) joints = joint_transforms(document_, *placement.skin, nodes_.world_from_node);
    const bool normals_are_there = !primitive.normals.empty();
    Eigen::Affine3d world = placement.world_from_mesh;
    const auto for_normals = [&] {
      return Eigen::Matrix3d((scene_from_file.linear() * world.linear()).inverse().transpose());
    };
    Eigen::Matrix3d of_normals = for_normals();
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
      if (!primitive.poses.empty()) {
        world = posed(primitive.poses[i], joints);
        if (normals_are_there) of_normals = for_normals();
      }
      const Eigen::Vector3f position =
          (scene_from_file * (world * primitive.positions[i].cast<double>())).cast<float>();
      if (!position.allFinite())
        throw InputError(document_.file().string(), "mesh \"" + mesh.name + "\"",
                         "vertex " + std::to_string(i) + " is not finite", "finite positions");
      mesh.positions.push_back(position);
      if (normals_are_there) normals.push_back(of_normals * primitive.normals[i].cast<double>());
    }
    if (world.linear().determinant() < 0.0)
      for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    mesh.normals = normals_that_bend(normals, mesh);
    return mesh;
  }

  void note(const std::string& text) { result_.notes.push_back(document_.file().filename().string() + ": " + text); }

  void note_what_is_left_out() {
    const Json& gltf = document_.json();
    if (const Json* lights = extension(gltf, "KHR_lights_punctual"))
      if (const Json& all = list(*lights, "lights", document_.root() / "extensions" / "KHR_lights_punctual");
          !all.empty())
        note(std::to_string(all.size()) + " lights of the file are left out");
    if (const Json& cameras = list(gltf, "cameras", document_.root()); !cameras.empty())
      note(std::to_string(cameras.size()) + " cameras of the file are left out");
    if (!list(gltf, "animations", document_.root()).empty())
      note("animations are left out: everything stands as at the start");
  }

  ModelPlacement model_;
  SceneDescription result_;
  Document document_;
  Materials materials_;
  PrimitiveReader reader_;
  const Json& meshes_;
  Nodes nodes_;
  std::size_t vertices_ = 0;
  std::vector<Placement> placements_;
  std::map<Shape, int> shown_;  // how often
  std::map<std::pair<Shape, std::size_t>, int> prototype_of_;
};

}  // namespace

SceneDescription import_gltf(const ModelSpec& spec) {
  return GltfImport(spec).run();
}

}  // namespace sturm
