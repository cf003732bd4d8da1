#pragma once
#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pathtrace/lights/light_set.h"
#include "pathtrace/scene/cut_outs.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// What a ray hit, with all that shading needs.
struct SurfacePoint {
  Eigen::Vector3f position;        ///< [m], world
  Eigen::Vector3f normal;          ///< geometric, unit length, on the side from which the mesh emits
  Eigen::Vector3f shading_normal;  ///< interpolated from the vertices where the mesh has normals, on the side of
                                   ///< `normal`; else the same
  const Material* material;
  int emitter;               ///< index into the light set, −1 where the surface does not emit
  Eigen::Vector3f albedo;    ///< texture and vertex colours applied
  Eigen::Vector3f emission;  ///< texture applied; only where it emits
};

/// Immutable scene on Embree 3: all triangles in one geometry, those that rays may pass in another, all spheres in a
/// third; repeated meshes are Embree instances.
class Scene {
 public:
  /// What its surfaces and its surroundings ask of a path tracer, each kind more than the one before it.
  enum class Kind {
    plain,    ///< Lambert, flat, nothing around
    diffuse,  ///< Lambert, with smooth normals or an environment
    mixed     ///< any surface model
  };

  /// `isa` names the instruction set that Embree is pinned to ("" = its own choice); hits differ between instruction
  /// sets in the last bits. Throws InputError for non-finite or out-of-range vertices, indices, materials and radii,
  /// for a wrong number of texture coordinates, and for a scene without any surface.
  explicit Scene(const SceneDescription& description, const std::string& isa = "avx2");

  RTCScene embree() const { return scene_.get(); }
  const LightSet& lights() const { return lights_; }
  Kind kind() const { return kind_; }

  /// Radiance of the surroundings seen along a direction of any length but 0; zero where there are none.
  Eigen::Vector3f environment(const Eigen::Vector3f& direction) const {
    return environment_map_ ? environment_map_->radiance(direction) : constant_environment_;
  }
  bool has_environment() const { return environment_map_ || constant_environment_.maxCoeff() > 0.0f; }
  const Eigen::Vector3f& lower() const { return lower_; }
  const Eigen::Vector3f& upper() const { return upper_; }
  /// What lengths by which rays keep off surfaces are measured in [m] (offset_from_surface): 1 where the scene reaches
  /// at least 1/4 m from the origin, else a power of two that shrinks with it.
  float offset_unit() const { return offset_unit_; }
  /// Triangles in memory: those of a prototype count once.
  std::size_t triangle_count() const { return triangles_.size(); }
  const std::string& instruction_set() const { return instruction_set_; }

  /// Resolves an Embree hit of the ray origin + t·direction.
  SurfacePoint surface_point(const RTCHit& hit, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                             float t) const;

  /// Whether a ray sees light of the surface itself there; the cheaper part of surface_point.
  bool shines(const RTCHit& hit, const Eigen::Vector3f& direction) const;

 private:
  struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  };
  struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  using EmbreeScene = std::unique_ptr<RTCSceneTy, SceneRelease>;

  struct Triangle {
    Eigen::Vector3f
        normal;  ///< unit length, on the side that sees the corners counter-clockwise; a prototype's in its own frame
    int material, emitter;  ///< index into the light set, −1: it does not emit
  };

  /// Where an instance's facts are, and how its normals become the world's.
  struct PlacedInstance {
    std::size_t first_triangle;
    Eigen::Matrix3f normal_from_prototype;
  };

  void validate_meshes(const SceneDescription& description);
  void add_triangles(const std::vector<const Mesh*>& meshes, RTCScene into);
  void add_facts(const Mesh& mesh);
  void add_lookups(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners);
  std::size_t number_in_place(const RTCHit& hit) const;
  static Eigen::Vector3f emission_at(const Material& material, const Eigen::Vector2f& coordinate);
  void look_up(SurfacePoint& point, const Material& material, std::size_t triangle, float u, float v) const;
  void add_instances(const SceneDescription& description);
  void add_spheres(const SceneDescription& description);
  void add_environment(const Environment& environment);
  Eigen::Vector3f smooth_normal(std::size_t triangle, float u, float v, const PlacedInstance* instance,
                                const Eigen::Vector3f& geometric) const;

  std::string instruction_set_;
  std::unique_ptr<RTCDeviceTy, DeviceRelease> device_;
  EmbreeScene scene_;
  std::vector<EmbreeScene> prototypes_;
  std::vector<PlacedInstance> instances_;
  std::unique_ptr<CutOuts> cut_outs_;
  std::size_t first_cut_out_ = 0;  ///< index of the first triangle of the geometry that rays may pass
  bool textured_ = false, smooth_ = false, coloured_ = false, lit_by_textures_ = false;
  std::vector<Material> materials_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<Eigen::Vector2f, 3>> triangle_uv_;  // empty when no mesh is textured
  std::vector<std::array<Eigen::Vector3f, 3>>
      triangle_normals_;  // empty when no mesh is smooth; zero vectors on flat meshes
  std::vector<std::array<Eigen::Vector3f, 3>> triangle_colours_;      // empty when no mesh has colours
  std::vector<std::array<Eigen::Vector2f, 3>> triangle_emission_uv_;  // empty when no emission is textured
  std::vector<int> sphere_material_, sphere_emitter_;
  std::shared_ptr<const EnvironmentMap> environment_map_;
  Eigen::Vector3f constant_environment_{0.0f, 0.0f, 0.0f};
  Kind kind_ = Kind::plain;
  LightSet lights_;
  Eigen::Vector3f lower_, upper_;
  float offset_unit_ = 1.0f;
};

/// The kind that a scene has once it is built: Scene(description).kind().
Scene::Kind kind_of(const SceneDescription& description);

}  // namespace sturm
