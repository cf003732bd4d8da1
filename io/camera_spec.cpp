#include "io/camera_spec.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "io/json_vectors.h"
#include "lensmodel/units.h"

namespace sturm {

CameraSpec read_camera(const Json& value, const Source& where) {
  CameraSpec camera;
  camera.position = read_vector3(value.at("position_m"));
  camera.look_at = read_vector3(value.at("look_at_m"));
  if (value.contains("up")) camera.up = read_vector3(value["up"]);
  camera.vfov = radians_per_degree * value.at("vfov_deg").get<double>();
  camera.width = value.at("resolution")[0].get<int>();
  camera.height = value.at("resolution")[1].get<int>();

  const Eigen::Vector3d look = camera.look_at - camera.position;
  if (!(look.norm() > 1e-9 * (1.0 + camera.position.norm())))
    (where / "look_at_m").fail(value["look_at_m"], "a point away from position_m");
  // sin of the angle between them; 1e-6 leaves ten digits to the picture's horizontal.
  if (!(camera.up.norm() > 0.0 && camera.up.normalized().cross(look.normalized()).norm() > 1e-6))
    (where / "up").fail(value.value("up", Json::array({0, 1, 0})), "a direction that is not parallel to the line of sight");
  return camera;
}

}  // namespace sturm
