#include "io/specs/camera_spec.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/values.h"
#include "io/specs/words.h"
#include "lensmodel/units.h"

namespace sturm {

LineOfSight read_line_of_sight(const Json& value, const Source& where) {
  const LineOfSight sight{read_vector3(value.at("position_m")), read_vector3(value.at("look_at_m")),
                          value.contains("up") ? read_vector3(value["up"]) : Eigen::Vector3d(0.0, 1.0, 0.0)};
  const Eigen::Vector3d look = sight.look_at - sight.position;
  if (!(look.norm() > 1e-9 * (1.0 + sight.position.norm())))
    (where / "look_at_m").fail(value["look_at_m"], "a point away from position_m");
  // sin of the angle between them; 1e-6 leaves ten digits to the picture's horizontal.
  if (!(sight.up.norm() > 0.0 && sight.up.normalized().cross(look.normalized()).norm() > 1e-6))
    (where / "up")
        .fail(value.value("up", Json::array({0, 1, 0})), "a direction that is not parallel to the line of sight");
  return sight;
}

CameraSpec read_camera(const Json& value, const Source& where) {
  CameraSpec camera;
  camera.projection = word_or(value, "projection", camera.projection, where, projection_words);
  camera.gaze = word_or(value, "gaze", camera.gaze, where, gaze_words);
  if (camera.projection == Projection::Equirectangular) {
    if (value.contains("vfov_deg"))
      (where / "vfov_deg").fail(value["vfov_deg"], "no \"vfov_deg\" for an equirectangular picture");
    if (camera.gaze == Gaze::Foveal)
      (where / "gaze").fail(value["gaze"], "\"camera\": an eye cannot turn to the whole sphere");
  } else {
    if (!value.contains("vfov_deg"))
      throw InputError(where.file, where.pointer, "no \"vfov_deg\"", "the vertical field of view [deg]");
    camera.vfov = radians_per_degree * value["vfov_deg"].get<double>();
  }
  if (value.contains("stereo"))
    camera.interpupillary_distance_m =
        metres_per_millimetre * value["stereo"]["interpupillary_distance_mm"].get<double>();
  camera.width = value.at("resolution")[0].get<int>();
  camera.height = value.at("resolution")[1].get<int>();
  const LineOfSight sight = read_line_of_sight(value, where);
  camera.position = sight.position;
  camera.look_at = sight.look_at;
  camera.up = sight.up;
  return camera;
}

void require_plain_camera(const Json& value, const Source& where, const std::string& what) {
  if (value.value("projection", "perspective") != "perspective")
    (where / "projection").fail(value["projection"], "\"perspective\" for " + what);
  if (value.value("gaze", "camera") != "camera") (where / "gaze").fail(value["gaze"], "\"camera\" for " + what);
  if (value.contains("stereo")) (where / "stereo").fail(value["stereo"], "no stereo pair for " + what);
}

}  // namespace sturm
