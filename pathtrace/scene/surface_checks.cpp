#include "pathtrace/scene/surface_checks.h"

#include <cmath>

#include "io/files/error.h"
#include "pathtrace/scene/message_text.h"

namespace sturm {
namespace {

constexpr float largest_coordinate = 1e6f;  // [m]; beyond it single precision cannot resolve a millimetre

void require_material(int material, std::size_t count, const std::string& where) {
  if (material < 0 || static_cast<std::size_t>(material) >= count)
    throw InputError("", where, "material " + std::to_string(material),
                     "0 to " + std::to_string(static_cast<long long>(count) - 1));
}

}  // namespace

void require_usable(const Eigen::Vector3f& p, const std::string& where) {
  if (!(p.array().abs() <= largest_coordinate).all())
    throw InputError("", where,
                     "(" + exact_number(p.x()) + ", " + exact_number(p.y()) + ", " + exact_number(p.z()) + ")",
                     "finite coordinates within ±1e6 m");
}

void require_usable(const Mesh& mesh, std::size_t material_count) {
  const std::string where = "mesh '" + mesh.name + "'";
  require_material(mesh.material, material_count, where);
  for (const Eigen::Vector3f& p : mesh.positions) require_usable(p, where);
  for (const auto& triangle : mesh.triangles)
    for (std::uint32_t v : triangle)
      if (v >= mesh.positions.size())
        throw InputError("", where, "vertex index " + std::to_string(v),
                         "less than " + std::to_string(mesh.positions.size()));
  if (!mesh.texture_coordinates.empty() && mesh.texture_coordinates.size() != mesh.positions.size())
    throw InputError("", where, std::to_string(mesh.texture_coordinates.size()) + " texture coordinates",
                     "one for each of " + std::to_string(mesh.positions.size()) + " positions, or none");
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
    throw InputError("", where, std::to_string(mesh.normals.size()) + " normals",
                     "one for each of " + std::to_string(mesh.positions.size()) + " positions, or none");
  if (!mesh.vertex_colours.empty() && mesh.vertex_colours.size() != mesh.positions.size())
    throw InputError("", where, std::to_string(mesh.vertex_colours.size()) + " vertex colours",
                     "one for each of " + std::to_string(mesh.positions.size()) + " positions, or none");
  for (const Eigen::Vector3f& n : mesh.normals)
    if (!(std::abs(n.squaredNorm() - 1.0f) < 1e-3f))
      throw InputError("", where, "a normal of length " + exact_number(n.norm()), "unit normals");
}

void require_usable(const Sphere& sphere, std::size_t material_count) {
  require_material(sphere.material, material_count, "sphere");
  require_usable(sphere.center, "sphere");
  if (!(sphere.radius > 0.0f && sphere.radius <= largest_coordinate))
    throw InputError("", "sphere", "radius " + exact_number(sphere.radius) + " m", "a radius above 0");
}

}  // namespace sturm
