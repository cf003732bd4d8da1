#include "pathtrace/scene/gltf/primitive.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/files/error.h"
#include "pathtrace/scene/gltf/members.h"
#include "pathtrace/scene/gltf/triangles.h"

namespace sturm::gltf {

/// A primitive on its way.
struct PrimitiveReader::Place {
  const Json& primitive;
  Source where;
  const Json& attributes;
  std::string called;  ///< for messages
  const PrimitiveRequest& request;
  std::vector<std::uint32_t> vertices;  ///< those that are taken
  std::size_t accessors;

  Source attribute(const std::string& name) const { return where / "attributes" / name; }
};

namespace {

std::string name_of(const Document& document, const PrimitiveRequest& request, std::size_t primitives) {
  const Json& mesh = document.json()["meshes"][request.mesh];
  std::string name = text(mesh, "name", document.root() / "meshes" / request.mesh, "");
  if (name.empty()) name = "meshes[" + std::to_string(request.mesh) + "]";
  return primitives > 1 ? name + "-" + std::to_string(request.number) : name;
}

template <int components>
std::vector<Eigen::Matrix<float, components, 1>> taken(const Elements& all,
                                                       const std::vector<std::uint32_t>& vertices) {
  std::vector<Eigen::Matrix<float, components, 1>> list;
  list.reserve(vertices.size());
  for (const std::uint32_t v : vertices) list.emplace_back(all.at(v));
  return list;
}

}  // namespace

/// An attribute's elements, one for each position, moved towards the morph targets. Empty where there is no such
/// attribute.
Elements PrimitiveReader::morphed(const Place& place, const std::string& attribute, std::size_t least,
                                  std::size_t most) const {
  const auto accessor =
      index(place.attributes, attribute.c_str(), place.where / "attributes", place.accessors, "accessor");
  if (!accessor) return {};
  Elements result = elements(document_, *accessor, least, most, place.attribute(attribute));
  const Json& targets = list(place.primitive, "targets", place.where);
  for (std::size_t t = 0; t < std::min(targets.size(), place.request.morph_weights.size()); ++t) {
    const auto weight = static_cast<float>(place.request.morph_weights[t]);
    const Source where = place.where / "targets" / t;
    const auto moved = targets[t].is_object() ? index(targets[t], attribute.c_str(), where, place.accessors, "accessor")
                                              : std::nullopt;
    if (weight == 0.0f || !moved) continue;
    const Elements by = elements(document_, *moved, least, result.components, where / attribute);
    if (by.count() != result.count())
      throw InputError(where.file, where.pointer + "/" + attribute, std::to_string(by.count()) + " elements",
                       std::to_string(result.count()) + ", as the attribute has");
    for (std::size_t i = 0; i < result.count(); ++i)
      for (std::size_t c = 0; c < by.components; ++c)
        result.values[i * result.components + c] += weight * by.values[i * by.components + c];
  }
  return result;
}

std::optional<Primitive> PrimitiveReader::read(const PrimitiveRequest& request) {
  const Source mesh_place = document_.root() / "meshes" / request.mesh;
  const Json& primitives = list(document_.json()["meshes"][request.mesh], "primitives", mesh_place);
  const Json& primitive = primitives[request.number];
  const Source where = mesh_place / "primitives" / request.number;
  if (!primitive.is_object()) where.fail(primitive, "an object");
  Primitive result;
  result.name = name_of(document_, request, primitives.size());
  Place place{primitive,
              where,
              object(primitive, "attributes", where),
              "mesh \"" + result.name + "\"",
              request,
              {},
              list(document_.json(), "accessors", document_.root()).size()};
  const std::uint64_t mode = number(primitive, "mode", where, 4);
  if (mode > 6) (where / "mode").fail(primitive["mode"], "a number from 0 to 6");
  if (mode < 4 || !place.attributes.contains("POSITION")) {
    note(place.called + " has " + (mode < 4 ? "points or lines" : "no positions") + ": it is left out");
    return std::nullopt;
  }
  const Elements positions = morphed(place, "POSITION", 3, 3);
  if (extension(primitive, "KHR_draco_mesh_compression") &&
      !document_.json()["accessors"][place.attributes["POSITION"].get<std::size_t>()].contains("bufferView"))
    throw InputError(where.file, where.pointer + "/extensions/KHR_draco_mesh_compression", "Draco compression",
                     "a file that also holds the plain form of its meshes");
  std::vector<std::uint32_t> corners;
  if (const auto indices = index(primitive, "indices", where, place.accessors, "accessor")) {
    corners = whole_numbers(document_, *indices, where / "indices");
    for (const std::uint32_t corner : corners)
      if (corner >= positions.count())
        throw InputError(
            where.file, where.pointer + "/indices", std::to_string(corner),
            "the number of a vertex, less than " + std::to_string(positions.count()) + " (" + place.called + ")");
  } else {
    corners.resize(positions.count());
    std::iota(corners.begin(), corners.end(), 0u);
  }
  result.triangles = triangles_of(corners, static_cast<TriangleMode>(mode));
  if (result.triangles.empty()) return std::nullopt;
  place.vertices = used_vertices(result.triangles, positions.count());
  result.positions = taken<3>(positions, place.vertices);
  for (const std::uint32_t v : place.vertices)
    if (!std::isfinite(positions.at(v)[0]) || !std::isfinite(positions.at(v)[1]) || !std::isfinite(positions.at(v)[2]))
      throw InputError(where.file, where.pointer + "/attributes/POSITION",
                       "vertex " + std::to_string(v) + " is not finite", "finite positions (" + place.called + ")");
  if (const Elements normals = morphed(place, "NORMAL", 3, 3); normals.count() == positions.count())
    result.normals = taken<3>(normals, place.vertices);
  read_colours(place, result);
  MaterialUse use;
  use.material =
      index(primitive, "material", where, list(document_.json(), "materials", document_.root()).size(), "material");
  use.coloured = !result.colours.empty();
  use.translucent = std::any_of(result.colours.begin(), result.colours.end(),
                                [](const Eigen::Vector4f& colour) { return colour.w() < 1.0f; });
  result.material = materials_.placed(use);
  read_coordinates(place, result);
  if (request.skinned) read_poses(place, result);
  return result;
}

void PrimitiveReader::read_coordinates(const Place& place, Primitive& result) {
  const auto &first = result.material.coordinates, &second = result.material.emission_coordinates;
  if (first || second) result.coordinates = coordinates(place, first ? *first : *second);
  if (first && second && *first != *second) result.emission_coordinates = coordinates(place, *second);
}

std::vector<Eigen::Vector2f> PrimitiveReader::coordinates(const Place& place, std::size_t set) {
  const std::string attribute = "TEXCOORD_" + std::to_string(set);
  const Elements all = morphed(place, attribute, 2, 2);
  if (all.count() <= place.vertices.back()) {
    note(place.called + " has no " + attribute + " for its texture: the picture's upper left corner is taken");
    return std::vector<Eigen::Vector2f>(place.vertices.size(), Eigen::Vector2f(0.0f, 1.0f));
  }
  std::vector<Eigen::Vector2f> list = taken<2>(all, place.vertices);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].allFinite())
      throw InputError(place.where.file, place.attribute(attribute).pointer,
                       "texture coordinate " + std::to_string(place.vertices[i]) + " is not finite",
                       "finite coordinates (" + place.called + ")");
    list[i].y() = 1.0f - list[i].y();
  }
  return list;
}

void PrimitiveReader::read_colours(const Place& place, Primitive& result) {
  const Elements all = morphed(place, "COLOR_0", 3, 4);
  if (all.count() <= place.vertices.back()) return;
  bool plain = true, clamped = false;
  for (const std::uint32_t v : place.vertices) {
    Eigen::Vector4f colour(0.0f, 0.0f, 0.0f, 1.0f);
    for (std::size_t c = 0; c < all.components; ++c) {
      if (!std::isfinite(all.at(v)[c]))
        throw InputError(place.where.file, place.attribute("COLOR_0").pointer,
                         "colour " + std::to_string(v) + " is not finite", "finite colours (" + place.called + ")");
      float& value = colour[static_cast<Eigen::Index>(c)];
      value = std::clamp(all.at(v)[c], 0.0f, 1.0f);
      clamped = clamped || value != all.at(v)[c];
    }
    plain = plain && colour == Eigen::Vector4f::Ones();
    result.colours.push_back(colour);
  }
  if (plain) result.colours.clear();  // they change nothing
  if (clamped) note(place.called + ": vertex colours are limited to 0 … 1");
}

void PrimitiveReader::read_poses(const Place& place, Primitive& result) const {
  result.poses.resize(place.vertices.size());
  for (std::size_t set = 0; set < 2; ++set) {
    const Elements joints = morphed(place, "JOINTS_" + std::to_string(set), 4, 4),
                   weights = morphed(place, "WEIGHTS_" + std::to_string(set), 4, 4);
    if (std::min(joints.count(), weights.count()) <= place.vertices.back()) continue;
    for (std::size_t i = 0; i < place.vertices.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        result.poses[i].joints[4 * set + k] = static_cast<std::uint32_t>(joints.at(place.vertices[i])[k]);
        result.poses[i].weights[4 * set + k] = weights.at(place.vertices[i])[k];
      }
  }
}

void PrimitiveReader::note(const std::string& text) {
  const std::string full = document_.file().filename().string() + ": " + text;
  if (std::find(notes_.begin(), notes_.end(), full) == notes_.end()) notes_.push_back(full);
}

}  // namespace sturm::gltf
