#include "stages/camera_check_scene.h"

#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/files/formatted_text.h"
#include "io/json/json_text.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr int samples_per_pixel = 256;

/// Counter-clockwise as the camera sees them.
std::array<Eigen::Vector3d, 4> corners_of(const CheckedLamp& lamp) {
  const double h = 0.5 * lamp.side_m;
  const Eigen::Vector3d &m = lamp.position_m, x(h, 0.0, 0.0), y(0.0, h, 0.0);
  return {m - x - y, m + x - y, m + x + y, m - x + y};
}

std::string wavefront_obj(const CameraCheck& check) {
  std::string text = "mtllib scene.mtl\n";
  int first = 1;
  for (const CheckedLamp& lamp : check.lamps) {
    text += "o " + lamp.id + "\nusemtl lamp\n";
    for (const Eigen::Vector3d& c : corners_of(lamp)) text += formatted("v %.9g %.9g %.9g\n", c.x(), c.y(), c.z());
    text += formatted("f %d %d %d %d\n", first, first + 1, first + 2, first + 3);
    first += 4;
  }
  return text;
}

template <class Number>
void append(std::string& bytes, Number value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// Positions of all lamps, then the two triangles that each of them has.
std::string gltf_buffer(const CameraCheck& check) {
  std::string bytes;
  for (const CheckedLamp& lamp : check.lamps)
    for (const Eigen::Vector3d& c : corners_of(lamp))
      for (const double value : c) append(bytes, static_cast<float>(value));
  for (const std::uint16_t index : {0, 1, 2, 0, 2, 3}) append(bytes, index);
  return bytes;
}

Json position_accessor(const CheckedLamp& lamp, std::size_t number) {
  constexpr std::size_t bytes_per_lamp = 4 * 3 * sizeof(float);
  Json low = Json::array(), high = Json::array();
  const auto corners = corners_of(lamp);
  for (int axis = 0; axis < 3; ++axis) {
    low.push_back(static_cast<float>(corners[0][axis]));
    high.push_back(static_cast<float>(corners[2][axis]));
  }
  return {{"bufferView", 0},
          {"byteOffset", number * bytes_per_lamp},
          {"componentType", 5126},
          {"count", 4},
          {"type", "VEC3"},
          {"min", low},
          {"max", high}};
}

std::string gltf(const CameraCheck& check) {
  const std::size_t positions = check.lamps.size() * 4 * 3 * sizeof(float), indices = 6 * sizeof(std::uint16_t);
  Json accessors = Json::array(), meshes = Json::array(), nodes = Json::array(), roots = Json::array();
  for (std::size_t i = 0; i < check.lamps.size(); ++i) {
    accessors.push_back(position_accessor(check.lamps[i], i));
    meshes.push_back(
        {{"name", check.lamps[i].id},
         {"primitives", {{{"attributes", {{"POSITION", i}}}, {"indices", check.lamps.size()}, {"material", 0}}}}});
    nodes.push_back({{"name", check.lamps[i].id}, {"mesh", i}});
    roots.push_back(i);
  }
  accessors.push_back({{"bufferView", 1}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}});
  nodes.push_back({{"name", "camera"}, {"camera", 0}});
  roots.push_back(check.lamps.size());
  const Json document = {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", roots}}}},
      {"nodes", nodes},
      {"cameras",
       {{{"type", "perspective"},
         {"perspective",
          {{"yfov", radians_per_degree * check.vfov_deg},
           {"aspectRatio", double(check.width) / check.height},
           {"znear", 0.01},
           {"zfar", 100.0}}}}}},
      {"meshes", meshes},
      {"materials",
       {{{"name", "lamp"},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
         {"emissiveFactor", {1, 1, 1}}}}},
      {"accessors", accessors},
      {"bufferViews",
       {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", positions}},
        {{"buffer", 0}, {"byteOffset", positions}, {"byteLength", indices}}}},
      {"buffers", {{{"uri", "scene.bin"}, {"byteLength", positions + indices}}}}};
  return json_text(document, 1) + "\n";
}

Json camera_json(const CameraCheck& check) {
  return {{"position_m", {0, 0, 0}},
          {"look_at_m", {0, 0, -1}},
          {"up", {0, 1, 0}},
          {"vfov_deg", check.vfov_deg},
          {"resolution", {check.width, check.height}}};
}

std::string view(const CameraCheck& check, const Json& eye) {
  const Json document = {{"format", "sturm.render/1"},
                         {"scene", {{"models", {{{"file", "scene.obj"}}}}}},
                         {"camera", camera_json(check)},
                         {"eye", eye},
                         {"method",
                          {{"type", "path_trace"},
                           {"ray_model", "power_matrix"},
                           {"samples_per_pixel", samples_per_pixel},
                           {"max_bounces", 1}}},
                         {"seed", 1}};
  return json_text(document, 1) + "\n";
}

/// Aperture and focus of a thin lens with the same rays; null for an eye with a cylinder, or focused beyond infinity.
Json thin_lens(const Eye& eye) {
  const Eigen::Matrix2d slopes = eye.slope_matrix(eye.accommodation_for(0.0)).matrix();
  const double focus_D = -0.5 * slopes.trace();
  if (eye.wavefront || slopes(0, 1) != 0.0 || slopes(0, 0) != slopes(1, 1) || !(focus_D > 0.0)) return nullptr;
  return {{"aperture_radius_m", eye.pupil_radius_m}, {"focus_distance_m", 1.0 / focus_D}};
}

}  // namespace

std::map<std::string, std::string> camera_check_files(const CameraCheck& check, const Eye& eye,
                                                      const Json& eye_document) {
  Json camera = camera_json(check);
  camera["thin_lens"] = thin_lens(eye);
  camera["filter"] = "box, one pixel wide";
  return {{"scene.gltf", gltf(check)},
          {"scene.bin", gltf_buffer(check)},
          {"scene.obj", wavefront_obj(check)},
          {"scene.mtl", "newmtl lamp\nKd 0 0 0\nKe 1 1 1\n"},
          {"camera.json", json_text(camera, 1) + "\n"},
          {"view.json", view(check, eye_document)}};
}

}  // namespace sturm
