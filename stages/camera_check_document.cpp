#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/json/values.h"
#include "lensmodel/units.h"
#include "stages/camera_check.h"

namespace sturm {

namespace {

Json lamp_json(const CheckedLamp& lamp, double pixel_slope) {
  const Ellipse ellipse = Ellipse::of_second_moments(lamp.covariance_px);
  const double arcmin = arcminutes_per_radian * pixel_slope;
  return {{"id", lamp.id},
          {"position_m", {lamp.position_m.x(), lamp.position_m.y(), lamp.position_m.z()}},
          {"side_m", lamp.side_m},
          {"centroid_px", json_of(lamp.centroid_px)},
          {"covariance_px2", symmetric_json(lamp.covariance_px)},
          {"semi_axes_px", {ellipse.semi_major, ellipse.semi_minor}},
          {"semi_axes_arcmin", {arcmin * ellipse.semi_major, arcmin * ellipse.semi_minor}},
          {"orientation_deg", number_or_null(ellipse.orientation_deg)}};
}

Eigen::Vector2d pair_of(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>()};
}

}  // namespace

Json to_json(const CameraCheck& check, const Json& eye) {
  Json lamps = Json::array();
  for (const CheckedLamp& lamp : check.lamps) lamps.push_back(lamp_json(lamp, check.pixel_slope()));
  return {{"format", "sturm.camera_check/1"}, {"eye", eye},
          {"vfov_deg", check.vfov_deg},       {"resolution", {check.width, check.height}},
          {"window_px", check.window_px},     {"lamps", std::move(lamps)}};
}

CameraCheck read_camera_check(const Json& document, const std::string& file) {
  validate(document, "camera_check", file);
  CameraCheck check;
  check.vfov_deg = document["vfov_deg"].get<double>();
  check.width = document["resolution"][0].get<int>();
  check.height = document["resolution"][1].get<int>();
  check.window_px = document["window_px"].get<double>();
  for (const Json& value : document["lamps"]) {
    CheckedLamp lamp;
    lamp.id = value["id"].get<std::string>();
    const Json &position = value["position_m"], &covariance = value["covariance_px2"];
    lamp.position_m = {position[0].get<double>(), position[1].get<double>(), position[2].get<double>()};
    lamp.side_m = value["side_m"].get<double>();
    lamp.centroid_px = pair_of(value["centroid_px"]);
    lamp.covariance_px << covariance[0].get<double>(), covariance[1].get<double>(), covariance[1].get<double>(),
        covariance[2].get<double>();
    check.lamps.push_back(lamp);
  }
  return check;
}

}  // namespace sturm
