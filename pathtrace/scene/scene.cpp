#include "pathtrace/scene/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "pathtrace/scene/surface_checks.h"
#include "pathtrace/scene/texture.h"

namespace sturm {

namespace {

/// Without spatial splits: they take 7 % of the time more in a plain room, gain nothing on meshes, and are slow to
/// build.
constexpr RTCBuildQuality build_quality = RTC_BUILD_QUALITY_MEDIUM;

constexpr unsigned triangle_geometry = 0, sphere_geometry = 1, cut_out_geometry = 2, first_instance = 3;
constexpr float least_squared_area =
    1e-36f;  // [m⁴], of the doubled area; below, its square root is lost in single precision

/// Of a scene that reaches as far from the origin [m]. A power of two: scenes that differ by one look alike to the bit.
float offset_unit_of(float reach) {
  constexpr float least_reach = 0.25f;  // above it the offset is below 1/16000 of the scene
  return reach < least_reach && reach > 0.0f ? std::exp2(std::floor(std::log2(reach / least_reach))) : 1.0f;
}

bool emits(const Material& material) {
  return material.emission.maxCoeff() > 0.0f;
}

/// The normal, as long as twice the area. A triangle without area has none; as a point it cannot be hit.
Eigen::Vector3f doubled_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
  const Eigen::Vector3f& a = mesh.positions[corners[0]];
  return (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
}

/// For the choice of lights, which need not be exact but never 0 where something is emitted: of a texture, the mean
/// over some points of the triangle, and at least 1 % of the factor.
Eigen::Vector3f mean_emission(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners, const Material& material) {
  if (!material.emission_texture) return material.emission;
  const auto& coordinates = mesh.emission_coordinates.empty() ? mesh.texture_coordinates : mesh.emission_coordinates;
  constexpr int steps = 4;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  int points = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j, ++points) {
      const float u = (static_cast<float>(i) + 1.0f / 3.0f) / steps, v = (static_cast<float>(j) + 1.0f / 3.0f) / steps;
      const Eigen::Vector2f at =
          (1.0f - u - v) * coordinates[corners[0]] + u * coordinates[corners[1]] + v * coordinates[corners[2]];
      sum += texel(*material.emission_texture, material.emission_mapping, at, material.nearest_filter);
    }
  const Eigen::Vector3f mean = sum / static_cast<float>(points);
  return material.emission.cwiseProduct(mean.cwiseMax(0.01f));
}

}  // namespace

Scene::Kind kind_of(const SceneDescription& description) {
  const auto is_diffuse = [](const Material& m) { return std::holds_alternative<Diffuse>(m.surface); };
  if (!std::all_of(description.materials.begin(), description.materials.end(), is_diffuse)) return Scene::Kind::mixed;
  const auto is_smooth = [](const Mesh& mesh) { return !mesh.normals.empty(); };
  const bool smooth = std::any_of(description.meshes.begin(), description.meshes.end(), is_smooth) ||
                      std::any_of(description.prototypes.begin(), description.prototypes.end(), is_smooth);
  const std::optional<Environment>& around = description.environment;
  const bool surrounded = around && (around->map || around->radiance.maxCoeff() > 0.0f);
  return smooth || surrounded ? Scene::Kind::diffuse : Scene::Kind::plain;
}

Scene::Scene(const SceneDescription& description, const std::string& isa)
    : instruction_set_(isa.empty() ? "default" : isa),
      device_(rtcNewDevice(isa.empty() ? nullptr : ("isa=" + isa).c_str())),
      materials_(description.materials),
      lower_(Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity())),
      upper_(-lower_) {
  if (!device_) throw RuntimeFailure("Embree cannot create a device (isa=" + isa + ")");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneBuildQuality(scene_.get(), build_quality);
  validate_meshes(description);
  for (const Mesh& mesh : description.meshes)
    for (const Eigen::Vector3f& p : mesh.positions) {
      lower_ = lower_.cwiseMin(p);
      upper_ = upper_.cwiseMax(p);
    }
  // Lights are numbered in this order (pathtrace/plan/unseen_emitters.cpp).
  for (const bool cut_out : {false, true}) {
    std::vector<const Mesh*> meshes;
    for (const Mesh& mesh : description.meshes)
      if (is_cut_out(materials_[static_cast<std::size_t>(mesh.material)]) == cut_out) meshes.push_back(&mesh);
    if (cut_out) first_cut_out_ = triangles_.size();
    add_triangles(meshes, scene_.get());
  }
  add_instances(description);
  add_spheres(description);
  if (triangles_.empty() && sphere_material_.empty())
    throw InputError("", "/scene", "no surface", "at least one mesh or sphere");
  for (const PointLight& light : description.lights) lights_.add_point(light.position, light.intensity);
  if (description.environment) add_environment(*description.environment);
  for (const int light : description.unseen_emitters) lights_.leave_out(light);
  lights_.finish();
  kind_ = kind_of(description);
  offset_unit_ = offset_unit_of(lower_.cwiseAbs().cwiseMax(upper_.cwiseAbs()).maxCoeff());
  rtcCommitScene(scene_.get());
  if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
    throw RuntimeFailure("Embree could not build the scene (error " + std::to_string(error) + ")");
}

void Scene::validate_meshes(const SceneDescription& description) {
  const auto check = [&](const Mesh& mesh) {
    require_usable(mesh, materials_.size());
    const Material& material = materials_[mesh.material];
    const bool wants_texture = material.albedo_texture || material.emission_texture || material.opacity.texture;
    if (wants_texture && mesh.texture_coordinates.empty())
      throw InputError("", "mesh '" + mesh.name + "'", "a textured material", "texture coordinates on the mesh");
    textured_ = textured_ || wants_texture;
    smooth_ = smooth_ || !mesh.normals.empty();
    coloured_ = coloured_ || !mesh.vertex_colours.empty();
    lit_by_textures_ = lit_by_textures_ || material.emission_texture != nullptr;
  };
  for (const Mesh& mesh : description.meshes) check(mesh);
  for (const Mesh& mesh : description.prototypes) {
    check(mesh);
    if (emits(materials_[mesh.material]))
      throw InputError("", "mesh '" + mesh.name + "'", "an emitter as a prototype", "emitters in place");
  }
}

void Scene::add_triangles(const std::vector<const Mesh*>& meshes, RTCScene into) {
  std::size_t vertex_count = 0, triangle_count = 0;
  for (const Mesh* mesh : meshes) {
    vertex_count += mesh->positions.size();
    triangle_count += mesh->triangles.size();
  }
  if (triangle_count == 0) return;
  if (vertex_count > std::numeric_limits<std::uint32_t>::max() ||
      triangle_count > std::numeric_limits<std::uint32_t>::max())
    throw InputError("", "/scene", std::to_string(triangle_count) + " triangles",
                     "fewer than 2^32 triangles and vertices");

  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertex_count));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangle_count));
  if (!vertices || !indices) {
    rtcReleaseGeometry(geometry);
    throw RuntimeFailure("Embree has no memory for " + std::to_string(triangle_count) + " triangles");
  }
  std::uint32_t first_vertex = 0;
  for (const Mesh* mesh : meshes) {
    for (const Eigen::Vector3f& p : mesh->positions) vertices = std::copy_n(p.data(), 3, vertices);
    for (const auto& triangle : mesh->triangles) {
      const bool has_area = doubled_area(*mesh, triangle).squaredNorm() > least_squared_area;
      for (std::uint32_t v : triangle) *indices++ = first_vertex + (has_area ? v : triangle[0]);
    }
    add_facts(*mesh);
    first_vertex += static_cast<std::uint32_t>(mesh->positions.size());
  }
  const bool cut_out = is_cut_out(materials_[static_cast<std::size_t>(meshes.front()->material)]);
  if (cut_out) {
    if (!cut_outs_) cut_outs_ = std::make_unique<CutOuts>();
    cut_outs_->attach(geometry, meshes, materials_);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(into, geometry, cut_out ? cut_out_geometry : triangle_geometry);
  rtcReleaseGeometry(geometry);
}

/// What shading needs of each triangle, and its lights.
void Scene::add_facts(const Mesh& mesh) {
  const Material& material = materials_[static_cast<std::size_t>(mesh.material)];
  const bool varies = material.emission_texture || is_cut_out(material);
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](int k) { return mesh.positions[triangle[k]]; };
    int emitter = -1;
    if (emits(material)) {
      const Eigen::Vector3f radiance = mean_emission(mesh, triangle, material);
      emitter = lights_.add_triangle(corner(0), corner(1), corner(2), radiance, {.varies = varies});
      if (material.emits_behind)
        lights_.add_triangle(corner(0), corner(2), corner(1), radiance, {.behind = true, .varies = varies});
    }
    triangles_.push_back({doubled_area(mesh, triangle).stableNormalized(), static_cast<int>(mesh.material), emitter});
    add_lookups(mesh, triangle);
  }
}

/// What is interpolated over a triangle.
void Scene::add_lookups(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
  const auto at = [&](const auto& values, auto otherwise) {
    return values.empty() ? std::array{otherwise, otherwise, otherwise}
                          : std::array{values[corners[0]], values[corners[1]], values[corners[2]]};
  };
  const Eigen::Vector2f nowhere(0.0f, 0.0f);
  if (textured_) triangle_uv_.push_back(at(mesh.texture_coordinates, nowhere));
  if (smooth_) triangle_normals_.push_back(at(mesh.normals, Eigen::Vector3f(0.0f, 0.0f, 0.0f)));
  if (lit_by_textures_)
    triangle_emission_uv_.push_back(
        at(mesh.emission_coordinates.empty() ? mesh.texture_coordinates : mesh.emission_coordinates, nowhere));
  if (!coloured_) return;
  auto& colours = triangle_colours_.emplace_back();
  for (std::size_t k = 0; k < 3; ++k)
    colours[k] = mesh.vertex_colours.empty() ? Eigen::Vector3f(1.0f, 1.0f, 1.0f)
                                             : Eigen::Vector3f(mesh.vertex_colours[corners[k]].head<3>());
}

void Scene::add_instances(const SceneDescription& description) {
  std::vector<std::size_t> first_triangle;
  for (const Mesh& mesh : description.prototypes) {
    first_triangle.push_back(triangles_.size());
    EmbreeScene& prototype = prototypes_.emplace_back(rtcNewScene(device_.get()));
    rtcSetSceneBuildQuality(prototype.get(), build_quality);
    add_triangles({&mesh}, prototype.get());
    rtcCommitScene(prototype.get());
  }
  for (const Instance& instance : description.instances) {
    if (instance.prototype < 0 || static_cast<std::size_t>(instance.prototype) >= prototypes_.size())
      throw InputError("", "instance", "prototype " + std::to_string(instance.prototype), "one of the prototypes");
    const Mesh& mesh = description.prototypes[static_cast<std::size_t>(instance.prototype)];
    const Eigen::Matrix3f turn = instance.world_from_prototype.leftCols<3>();
    // Against the lengths of the axes: a small instance is no singular one.
    const float volume = turn.colwise().norm().prod();
    if (!(std::abs(turn.determinant()) > 1e-6f * volume))
      throw InputError("", "instance of mesh '" + mesh.name + "'", "a singular transformation",
                       "one that keeps a volume");
    for (const Eigen::Vector3f& p : mesh.positions) {
      const Eigen::Vector3f world = turn * p + instance.world_from_prototype.col(3);
      require_usable(world, "instance of mesh '" + mesh.name + "'");
      lower_ = lower_.cwiseMin(world);
      upper_ = upper_.cwiseMax(world);
    }
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, prototypes_[static_cast<std::size_t>(instance.prototype)].get());
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, instance.world_from_prototype.data());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, first_instance + static_cast<unsigned>(instances_.size()));
    rtcReleaseGeometry(geometry);
    instances_.push_back({first_triangle[static_cast<std::size_t>(instance.prototype)], turn.inverse().transpose()});
  }
}

void Scene::add_spheres(const SceneDescription& description) {
  if (description.spheres.empty()) return;
  for (const Sphere& sphere : description.spheres) require_usable(sphere, materials_.size());
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* data = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                           4 * sizeof(float), description.spheres.size()));
  if (!data) {
    rtcReleaseGeometry(geometry);
    throw RuntimeFailure("Embree has no memory for " + std::to_string(description.spheres.size()) + " spheres");
  }
  for (const Sphere& sphere : description.spheres) {
    data = std::copy_n(sphere.center.data(), 3, data);
    *data++ = sphere.radius;
    lower_ = lower_.cwiseMin(sphere.center - Eigen::Vector3f::Constant(sphere.radius));
    upper_ = upper_.cwiseMax(sphere.center + Eigen::Vector3f::Constant(sphere.radius));
    const Material& material = materials_[sphere.material];
    sphere_material_.push_back(sphere.material);
    sphere_emitter_.push_back(emits(material) ? lights_.add_sphere(sphere.center, sphere.radius, material.emission)
                                              : -1);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_.get(), geometry, sphere_geometry);
  rtcReleaseGeometry(geometry);
}

void Scene::add_environment(const Environment& environment) {
  if (!environment.map) {
    constant_environment_ = environment.radiance;
    return;
  }
  environment_map_ =
      std::make_shared<const EnvironmentMap>(environment.map, environment.radiance, environment.rotation);
  lights_.set_environment(environment_map_, 2.0f * (upper_ - lower_).norm());
}

Eigen::Vector3f Scene::smooth_normal(std::size_t triangle, float u, float v, const PlacedInstance* instance,
                                     const Eigen::Vector3f& geometric) const {
  const auto& corner = triangle_normals_[triangle];
  Eigen::Vector3f mean = (1.0f - u - v) * corner[0] + u * corner[1] + v * corner[2];
  if (instance) mean = instance->normal_from_prototype * mean;
  const float length = mean.norm();
  if (!(length > 0.0f)) return geometric;  // a flat mesh, or normals that cancel out
  const Eigen::Vector3f normal = mean / length;
  return normal.dot(geometric) < 0.0f ? Eigen::Vector3f(-normal) : normal;
}

SurfacePoint Scene::surface_point(const RTCHit& hit, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                                  float t) const {
  const PlacedInstance* instance = nullptr;
  if (!instances_.empty() && hit.instID[0] != RTC_INVALID_GEOMETRY_ID)
    instance = &instances_[hit.instID[0] - first_instance];
  const std::size_t primitive = instance ? instance->first_triangle + hit.primID : number_in_place(hit);
  const Triangle* triangle = instance || hit.geomID != sphere_geometry ? &triangles_[primitive] : nullptr;
  const Material& material =
      materials_[static_cast<std::size_t>(triangle ? triangle->material : sphere_material_[primitive])];
  SurfacePoint point;
  point.position = origin + t * direction;
  if (!triangle)
    point.normal = Eigen::Vector3f(hit.Ng_x, hit.Ng_y, hit.Ng_z).normalized();
  else if (instance)  // the inverse transpose keeps the side, also under a mirror
    point.normal = (instance->normal_from_prototype * triangle->normal).normalized();
  else
    point.normal = triangle->normal;
  point.shading_normal =
      triangle && smooth_ ? smooth_normal(primitive, hit.u, hit.v, instance, point.normal) : point.normal;
  point.material = &material;
  point.emitter = triangle ? triangle->emitter : sphere_emitter_[primitive];
  point.albedo = material.albedo;
  if (point.emitter >= 0) {
    point.emission = material.emission;
    if (triangle && material.emits_behind && point.normal.dot(direction) > 0.0f) {
      ++point.emitter;  // the light behind, seen from its own side
      point.normal = -point.normal;
      point.shading_normal = -point.shading_normal;
    }
  }
  if (triangle && (textured_ || coloured_)) look_up(point, material, primitive, hit.u, hit.v);
  return point;
}

void Scene::look_up(SurfacePoint& point, const Material& material, std::size_t triangle, float u, float v) const {
  const float w = 1.0f - u - v;
  const auto between = [=](const auto& corner) { return (w * corner[0] + u * corner[1] + v * corner[2]).eval(); };
  if (material.albedo_texture)
    point.albedo = point.albedo.cwiseProduct(texel(*material.albedo_texture, material.albedo_mapping,
                                                   between(triangle_uv_[triangle]), material.nearest_filter));
  if (coloured_) point.albedo = point.albedo.cwiseProduct(between(triangle_colours_[triangle]));
  if (point.emitter < 0 || !material.emission_texture) return;
  point.emission = emission_at(material, between(triangle_emission_uv_[triangle]));
  if (!(point.emission.maxCoeff() > 0.0f)) point.emitter = -1;
}

Eigen::Vector3f Scene::emission_at(const Material& material, const Eigen::Vector2f& coordinate) {
  return material.emission.cwiseProduct(
      texel(*material.emission_texture, material.emission_mapping, coordinate, material.nearest_filter));
}

std::size_t Scene::number_in_place(const RTCHit& hit) const {
  return hit.geomID == cut_out_geometry ? first_cut_out_ + hit.primID : hit.primID;
}

bool Scene::shines(const RTCHit& hit, const Eigen::Vector3f& direction) const {
  if (hit.instID[0] != RTC_INVALID_GEOMETRY_ID) return false;  // prototypes do not
  if (hit.geomID == sphere_geometry)
    return sphere_emitter_[hit.primID] >= 0 && Eigen::Vector3f(hit.Ng_x, hit.Ng_y, hit.Ng_z).dot(direction) < 0.0f;
  const std::size_t number = number_in_place(hit);
  const Triangle& triangle = triangles_[number];
  if (triangle.emitter < 0) return false;
  const Material& material = materials_[static_cast<std::size_t>(triangle.material)];
  if (!material.emits_behind && !(triangle.normal.dot(direction) < 0.0f)) return false;
  if (!material.emission_texture) return true;
  const auto& uv = triangle_emission_uv_[number];
  const Eigen::Vector2f at = (1.0f - hit.u - hit.v) * uv[0] + hit.u * uv[1] + hit.v * uv[2];
  return emission_at(material, at).maxCoeff() > 0.0f;
}

}  // namespace sturm
