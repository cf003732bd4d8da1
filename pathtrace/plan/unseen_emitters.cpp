#include "pathtrace/plan/unseen_emitters.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sturm {

namespace {

constexpr double in_plane = 1e-6;               // sine of the angle under which a corner is taken to lie in the plane
constexpr std::size_t most_corners = 20000000;  // looked at by all searches together

using EmitterBounds = Eigen::AlignedBox3f;

/// A plane with a front side.
struct Plane {
  Eigen::Vector3d corner, normal;

  double height(const Eigen::Vector3f& p) const { return normal.dot(p.cast<double>() - corner); }
  bool has_in_front(const Eigen::Vector3f& p) const {
    return height(p) > in_plane * (p.cast<double>() - corner).norm();
  }
  bool reaches_in_front(const EmitterBounds& box) const {
    for (int k = 0; k < 8; ++k)
      if (height(box.corner(static_cast<EmitterBounds::CornerType>(k))) > 0.0) return true;
    return false;
  }
};

class Search {
 public:
  explicit Search(const SceneDescription& scene) : scene_(scene) {
    for (const Mesh& mesh : scene.meshes) mesh_boxes_.push_back(box_of(mesh, Eigen::Affine3f::Identity()));
    for (const Instance& instance : scene.instances)
      instance_boxes_.push_back(box_of(scene.prototypes[static_cast<std::size_t>(instance.prototype)],
                                       Eigen::Affine3f(instance.world_from_prototype)));
  }

  bool anything_in_front_of(const Plane& plane) {
    // What was in front of the last emitter is mostly in front of the next.
    if (last_ && plane.has_in_front(*last_)) return true;
    for (const Sphere& sphere : scene_.spheres)
      if (plane.height(sphere.center) > -static_cast<double>(sphere.radius)) return true;
    for (const EmitterBounds& box : instance_boxes_)
      if (plane.reaches_in_front(box)) return true;
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
      if (!plane.reaches_in_front(mesh_boxes_[i])) continue;
      for (const Eigen::Vector3f& p : scene_.meshes[i].positions) {
        if (++looks_ > most_corners) return true;
        if (!plane.has_in_front(p)) continue;
        last_ = &p;
        return true;
      }
    }
    return false;
  }

 private:
  static EmitterBounds box_of(const Mesh& mesh, const Eigen::Affine3f& world_from_mesh) {
    EmitterBounds box;
    for (const Eigen::Vector3f& p : mesh.positions) box.extend(world_from_mesh * p);
    return box;
  }

  const SceneDescription& scene_;
  std::vector<EmitterBounds> mesh_boxes_, instance_boxes_;
  const Eigen::Vector3f* last_ = nullptr;
  std::size_t looks_ = 0;
};

}  // namespace

std::vector<int> unseen_emitters(const SceneDescription& scene) {
  std::vector<int> unseen;
  const auto emits = [&](const Mesh& mesh) {
    return scene.materials[static_cast<std::size_t>(mesh.material)].emission.maxCoeff() > 0.0f;
  };
  if (std::none_of(scene.meshes.begin(), scene.meshes.end(), emits)) return unseen;
  Search search(scene);
  int light = 0;
  for (const bool cut_out : {false, true})  // as the scene numbers them
    for (const Mesh& mesh : scene.meshes) {
      const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
      if (!emits(mesh) || is_cut_out(material) != cut_out) continue;
      for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
                              c = mesh.positions[t[2]].cast<double>();
        const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
        if (!search.anything_in_front_of({a, normal})) unseen.push_back(light);
        ++light;
        if (!material.emits_behind) continue;
        if (!search.anything_in_front_of({a, -normal})) unseen.push_back(light);
        ++light;
      }
    }
  return unseen;
}

}  // namespace sturm
