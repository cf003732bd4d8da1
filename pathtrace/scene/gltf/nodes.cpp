#include "pathtrace/scene/gltf/nodes.h"

#include <functional>
#include <string>

#include "io/files/error.h"
#include "pathtrace/scene/gltf/accessor.h"
#include "pathtrace/scene/gltf/members.h"

namespace sturm::gltf {

namespace {

/// Translation · rotation · scale. A quaternion is taken at unit length, or as no rotation where it is 0.
Eigen::Affine3d transform_of(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation,
                             const Eigen::Vector3d& scale) {
  const double length = rotation.norm();
  return Eigen::Translation3d(translation) *
         (length > 0.0 ? Eigen::Quaterniond(rotation.coeffs() / length) : Eigen::Quaterniond::Identity()) *
         Eigen::Scaling(scale);
}

Eigen::Affine3d parent_from_node(const Json& node, const Source& where) {
  Eigen::Affine3d transform;
  if (node.contains("matrix")) {
    const std::vector<double> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    transform.matrix() = Eigen::Matrix4d(reals(node, "matrix", where, identity).data());
    transform.makeAffine();
  } else {
    const auto t = reals(node, "translation", where, {0.0, 0.0, 0.0}),
               r = reals(node, "rotation", where, {0.0, 0.0, 0.0, 1.0}),
               s = reals(node, "scale", where, {1.0, 1.0, 1.0});
    transform = transform_of({t[0], t[1], t[2]}, {r[3], r[0], r[1], r[2]}, {s[0], s[1], s[2]});
  }
  if (!transform.matrix().allFinite()) where.fail(node, "a finite transform");
  return transform;
}

bool is_hidden(const Json& node, const Source& where) {
  const Json* visibility = extension(node, "KHR_node_visibility");
  return visibility && !flag(*visibility, "visible", where / "extensions" / "KHR_node_visibility", true);
}

/// The nodes that the file's scene begins with.
std::vector<std::size_t> roots_of(const Document& document, std::vector<std::string>& notes) {
  const Json &scenes = list(document.json(), "scenes", document.root()),
             &nodes = list(document.json(), "nodes", document.root());
  std::vector<std::size_t> roots;
  if (scenes.empty()) {
    std::vector<bool> is_child(nodes.size(), false);
    for (const Json& node : nodes)
      for (const Json& child : list(node, "children", document.root())) is_child[child.get<std::size_t>()] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!is_child[i]) roots.push_back(i);
    return roots;
  }
  const std::size_t shown = index(document.json(), "scene", document.root(), scenes.size(), "scene").value_or(0);
  const Source where = document.root() / "scenes" / shown;
  if (!scenes[shown].is_object()) where.fail(scenes[shown], "an object");
  for (const Json& root : list(scenes[shown], "nodes", where)) {
    if (!root.is_number_unsigned() || root.get<std::size_t>() >= nodes.size())
      (where / "nodes").fail(root, "the number of a node, less than " + std::to_string(nodes.size()));
    roots.push_back(root.get<std::size_t>());
  }
  if (scenes.size() > 1)
    notes.push_back(document.file().filename().string() + ": scene " + std::to_string(shown) + " is shown, " +
                    std::to_string(scenes.size() - 1) + " others of the file are left out");
  return roots;
}

}  // namespace

Nodes nodes_of(const Document& document, std::vector<std::string>& notes) {
  const Json& nodes = list(document.json(), "nodes", document.root());
  Nodes result;
  std::vector<Eigen::Affine3d> own;
  std::vector<bool> is_child(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    own.push_back(parent_from_node(nodes[i], document.root() / "nodes" / i));
    for (const Json& child : list(nodes[i], "children", document.root())) is_child[child.get<std::size_t>()] = true;
  }
  result.world_from_node = own;
  std::vector<bool> met(nodes.size(), false);
  const std::function<void(std::size_t, bool)> walk = [&](std::size_t at, bool shown) {
    if (shown && !met[at]) {
      shown = !is_hidden(nodes[at], document.root() / "nodes" / at);
      if (shown) result.shown.push_back(at);
      met[at] = true;
    }
    for (const Json& child : list(nodes[at], "children", document.root())) {
      const auto below = child.get<std::size_t>();
      result.world_from_node[below] = result.world_from_node[at] * own[below];
      walk(below, shown);
    }
  };
  // Skeletons may stand outside of the scene: every node gets its place first.
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!is_child[i]) walk(i, false);
  for (const std::size_t root : roots_of(document, notes)) walk(root, true);
  return result;
}

std::vector<Eigen::Affine3d> places_of(const Document& document, std::size_t node,
                                       const Eigen::Affine3d& world_from_node) {
  const Json* instancing = extension(document.json()["nodes"][node], "EXT_mesh_gpu_instancing");
  if (!instancing) return {world_from_node};
  const Source where = document.root() / "nodes" / node / "extensions" / "EXT_mesh_gpu_instancing";
  const Json& attributes = object(*instancing, "attributes", where);
  const std::size_t accessors = list(document.json(), "accessors", document.root()).size();
  const auto read = [&](const char* name, std::size_t components) {
    const auto accessor = index(attributes, name, where / "attributes", accessors, "accessor");
    return accessor ? elements(document, *accessor, components, components, where / "attributes" / name) : Elements{};
  };
  const Elements translations = read("TRANSLATION", 3), rotations = read("ROTATION", 4), scales = read("SCALE", 3);
  const std::size_t count = std::max({translations.count(), rotations.count(), scales.count()});
  std::vector<Eigen::Affine3d> places;
  for (std::size_t i = 0; i < count; ++i) {
    const auto three = [&](const Elements& all, double otherwise) {
      return i < all.count() ? Eigen::Vector3d(Eigen::Vector3f(all.at(i)).cast<double>())
                             : Eigen::Vector3d::Constant(otherwise);
    };
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    if (i < rotations.count()) turn.coeffs() = Eigen::Vector4f(rotations.at(i)).cast<double>();
    const Eigen::Affine3d place = world_from_node * transform_of(three(translations, 0.0), turn, three(scales, 1.0));
    if (!place.matrix().allFinite())
      throw InputError(where.file, where.pointer, "instance " + std::to_string(i), "finite transforms");
    places.push_back(place);
  }
  return places;
}

}  // namespace sturm::gltf
