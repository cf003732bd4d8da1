#include "pathtrace/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "pathtrace/texture.h"

namespace sturm {

namespace {

constexpr unsigned triangle_geometry = 0, sphere_geometry = 1;
constexpr float largest_coordinate = 1e6f;  // [m]; beyond it single precision cannot resolve a millimetre

void require_usable(const Eigen::Vector3f& p, const std::string& where) {
  if (!(p.array().abs() <= largest_coordinate).all())
    throw InputError("", where, "(" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ")",
                     "finite coordinates within ±1e6 m");
}

bool emits(const Material& material) {
  return material.emission.maxCoeff() > 0.0f;
}

void require_material(int material, std::size_t count, const std::string& where) {
  if (material < 0 || static_cast<std::size_t>(material) >= count)
    throw InputError("", where, "material " + std::to_string(material), "0 to " + std::to_string(static_cast<long long>(count) - 1));
}

void validate(const Mesh& mesh, std::size_t material_count) {
  const std::string where = "mesh '" + mesh.name + "'";
  require_material(mesh.material, material_count, where);
  for (const Eigen::Vector3f& p : mesh.positions) require_usable(p, where);
  for (const auto& triangle : mesh.triangles)
    for (std::uint32_t v : triangle)
      if (v >= mesh.positions.size())
        throw InputError("", where, "vertex index " + std::to_string(v), "less than " + std::to_string(mesh.positions.size()));
  if (!mesh.texture_coordinates.empty() && mesh.texture_coordinates.size() != mesh.positions.size())
    throw InputError("", where, std::to_string(mesh.texture_coordinates.size()) + " texture coordinates",
                     "one for each of " + std::to_string(mesh.positions.size()) + " positions, or none");
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
    throw InputError("", where, std::to_string(mesh.normals.size()) + " normals",
                     "one for each of " + std::to_string(mesh.positions.size()) + " positions, or none");
  for (const Eigen::Vector3f& n : mesh.normals)
    if (!(std::abs(n.squaredNorm() - 1.0f) < 1e-3f)) throw InputError("", where, "a normal of length " + std::to_string(n.norm()), "unit normals");
}

void validate(const Sphere& sphere, std::size_t material_count) {
  require_material(sphere.material, material_count, "sphere");
  require_usable(sphere.center, "sphere");
  if (!(sphere.radius > 0.0f && sphere.radius <= largest_coordinate))
    throw InputError("", "sphere", "radius " + std::to_string(sphere.radius) + " m", "a radius above 0");
}

}  // namespace

Scene::Scene(const SceneDescription& description, const std::string& isa)
    : instruction_set_(isa.empty() ? "default" : isa),
      device_(rtcNewDevice(isa.empty() ? nullptr : ("isa=" + isa).c_str())),
      materials_(description.materials),
      lower_(Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity())),
      upper_(-lower_) {
  if (!device_) throw RuntimeFailure("Embree cannot create a device (isa=" + isa + ")");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
  add_triangles(description);
  add_spheres(description);
  if (triangle_material_.empty() && sphere_material_.empty()) throw InputError("", "/scene", "no surface", "at least one mesh or sphere");
  for (const PointLight& light : description.lights) lights_.add_point(light.position, light.intensity);
  if (description.environment) add_environment(*description.environment);
  lights_.finish();
  const bool all_diffuse = std::all_of(materials_.begin(), materials_.end(),
                                       [](const Material& m) { return std::holds_alternative<Diffuse>(m.surface); });
  if (!all_diffuse)
    kind_ = Kind::mixed;
  else if (has_environment() || !triangle_normals_.empty())
    kind_ = Kind::diffuse;
  rtcCommitScene(scene_.get());
  if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
    throw RuntimeFailure("Embree could not build the scene (error " + std::to_string(error) + ")");
}

void Scene::add_triangles(const SceneDescription& description) {
  std::size_t vertex_count = 0, triangle_count = 0;
  bool textured = false, smooth = false;
  for (const Mesh& mesh : description.meshes) {
    validate(mesh, materials_.size());
    vertex_count += mesh.positions.size();
    triangle_count += mesh.triangles.size();
    const bool wants_texture = materials_[mesh.material].albedo_texture != nullptr;
    if (wants_texture && mesh.texture_coordinates.empty())
      throw InputError("", "mesh '" + mesh.name + "'", "a textured material", "texture coordinates on the mesh");
    textured = textured || wants_texture;
    smooth = smooth || !mesh.normals.empty();
  }
  if (triangle_count == 0) return;

  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices =
      static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertex_count));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangle_count));
  if (!vertices || !indices) {
    rtcReleaseGeometry(geometry);
    throw RuntimeFailure("Embree has no memory for " + std::to_string(triangle_count) + " triangles");
  }
  std::uint32_t first_vertex = 0;
  for (const Mesh& mesh : description.meshes) {
    for (const Eigen::Vector3f& p : mesh.positions) {
      lower_ = lower_.cwiseMin(p);
      upper_ = upper_.cwiseMax(p);
      vertices = std::copy_n(p.data(), 3, vertices);
    }
    const Material& material = materials_[mesh.material];
    for (const auto& triangle : mesh.triangles) {
      for (std::uint32_t v : triangle) *indices++ = first_vertex + v;
      triangle_material_.push_back(mesh.material);
      const auto corner = [&](int k) { return mesh.positions[triangle[k]]; };
      triangle_emitter_.push_back(emits(material) ? lights_.add_triangle(corner(0), corner(1), corner(2), material.emission) : -1);
      if (textured) {
        const bool has = !mesh.texture_coordinates.empty();
        const auto uv = [&](int k) { return has ? mesh.texture_coordinates[triangle[k]] : Eigen::Vector2f(0.0f, 0.0f); };
        triangle_uv_.push_back({uv(0), uv(1), uv(2)});
      }
      if (smooth) {
        const auto normal = [&](int k) { return mesh.normals.empty() ? Eigen::Vector3f(0.0f, 0.0f, 0.0f) : mesh.normals[triangle[k]]; };
        triangle_normals_.push_back({normal(0), normal(1), normal(2)});
      }
    }
    first_vertex += static_cast<std::uint32_t>(mesh.positions.size());
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_.get(), geometry, triangle_geometry);
  rtcReleaseGeometry(geometry);
}

void Scene::add_spheres(const SceneDescription& description) {
  if (description.spheres.empty()) return;
  for (const Sphere& sphere : description.spheres) validate(sphere, materials_.size());
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* data = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), description.spheres.size()));
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
    sphere_emitter_.push_back(emits(material) ? lights_.add_sphere(sphere.center, sphere.radius, material.emission) : -1);
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
  environment_map_ = std::make_shared<const EnvironmentMap>(environment.map, environment.radiance, environment.rotation);
  lights_.set_environment(environment_map_, 2.0f * (upper_ - lower_).norm());
}

Eigen::Vector3f Scene::smooth_normal(const RTCHit& hit, const Eigen::Vector3f& geometric) const {
  const auto& corner = triangle_normals_[hit.primID];
  const Eigen::Vector3f mean = (1.0f - hit.u - hit.v) * corner[0] + hit.u * corner[1] + hit.v * corner[2];
  const float square = mean.squaredNorm();
  if (!(square > 1e-12f)) return geometric;  // a flat mesh, or normals that cancel out
  const Eigen::Vector3f normal = mean / std::sqrt(square);
  return normal.dot(geometric) < 0.0f ? Eigen::Vector3f(-normal) : normal;
}

SurfacePoint Scene::surface_point(const RTCHit& hit, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float t) const {
  const bool triangle = hit.geomID == triangle_geometry;
  const int material_index = triangle ? triangle_material_[hit.primID] : sphere_material_[hit.primID];
  const Material& material = materials_[static_cast<std::size_t>(material_index)];
  SurfacePoint point;
  point.position = origin + t * direction;
  // Embree's normal of a triangle is (v1 − v0) × (v2 − v0): it points to the side that sees the winding counter-clockwise.
  point.normal = Eigen::Vector3f(hit.Ng_x, hit.Ng_y, hit.Ng_z).normalized();
  point.shading_normal = triangle && !triangle_normals_.empty() ? smooth_normal(hit, point.normal) : point.normal;
  point.material = &material;
  point.emitter = triangle ? triangle_emitter_[hit.primID] : sphere_emitter_[hit.primID];
  point.albedo = material.albedo;
  if (triangle && material.albedo_texture && !triangle_uv_.empty()) {
    const auto& uv = triangle_uv_[hit.primID];
    const Eigen::Vector2f at = (1.0f - hit.u - hit.v) * uv[0] + hit.u * uv[1] + hit.v * uv[2];
    point.albedo = point.albedo.cwiseProduct(texel(*material.albedo_texture, at, material.nearest_filter));
  }
  return point;
}

}  // namespace sturm
