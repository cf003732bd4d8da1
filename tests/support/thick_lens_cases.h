#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"
#include "support/reference_file.h"

namespace sturm::testing {

/// One case of tests/reference/thick_lens.json, turned from the examiner's frame (origin at the centre of rotation, z
/// outward, [mm]) into the wearer frame (origin at the pupil of primary gaze, z inward, [m]): x → −x, z → 13 mm − z.
struct ThickLensCase {
  nlohmann::json json;
  std::string id;
  Eye eye;
  Spectacles lens;
  Eigen::Vector3d gaze;

  static constexpr double rotation_center_m = 13e-3;

  static Eigen::Vector3d direction(const nlohmann::json& v) {
    return {-v[0].get<double>(), v[1].get<double>(), -v[2].get<double>()};
  }
  static Eigen::Vector3d point(const nlohmann::json& mm) {
    return 1e-3 * direction(mm) + Eigen::Vector3d(0.0, 0.0, rotation_center_m);
  }
  static Eigen::Vector2d pupil_point(const nlohmann::json& mm) {
    return 1e-3 * Eigen::Vector2d(-mm[0].get<double>(), mm[1].get<double>());
  }
  static Eigen::Matrix2d symmetric(const nlohmann::json& xx_xy_yy, double unit = 1.0) {
    const double xy = -unit * xx_xy_yy[1].get<double>();
    Eigen::Matrix2d m;
    m << unit * xx_xy_yy[0].get<double>(), xy, xy, unit * xx_xy_yy[2].get<double>();
    return m;
  }
};

/// The file's surfaces are tori with negative curvatures where the centre lies towards the eye; spheres where both are
/// equal.
inline Surface surface_of(const nlohmann::json& s) {
  const double x = -1e3 * s["cx_per_mm"].get<double>(), y = -1e3 * s["cy_per_mm"].get<double>();
  if (x == y) return SphereSurface{x};
  return TorusSurface(x, y, s["local_x_deg"].get<double>());
}

inline std::vector<ThickLensCase> thick_lens_cases() {
  std::vector<ThickLensCase> cases;
  const nlohmann::json file = reference_file("thick_lens.json");
  for (const nlohmann::json& c : file["cases"]) {
    const nlohmann::json &in = c["inputs"], &rx = in["Rx"], &lens = in["lens"];
    ThickLensCase one;
    one.json = c;
    one.id = c["id"].get<std::string>();
    one.eye = Eye::with({rx["S"].get<double>(), rx["C"].get<double>(), rx["A"].get<double>(), 12e-3},
                        1e-3 * in["pupil_mm"].get<double>());
    one.eye.rotation_center_m = ThickLensCase::rotation_center_m;
    one.lens.back = surface_of(lens["back"]);
    one.lens.front = surface_of(lens["front"]);
    one.lens.center_thickness_m = 1e-3 * lens["center_thickness_mm"].get<double>();
    one.lens.refractive_index = lens["index"].get<double>();
    one.lens.vertex_distance_m = 12e-3;
    one.gaze = ThickLensCase::direction(c["outputs"]["gaze_dir"]);
    cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace sturm::testing
