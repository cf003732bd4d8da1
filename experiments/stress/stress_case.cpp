#include "experiments/stress/stress_case.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/json/values.h"
#include "lensmodel/gaze.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

double curvature(double radius_mm) {
  return std::isinf(radius_mm) ? 0.0 : 1.0 / (metres_per_millimetre * radius_mm);
}

Surface surface_of(const SurfaceNumbers& n) {
  switch (n.kind) {
    case SurfaceNumbers::Kind::torus:
      return TorusSurface(curvature(n.radius_mm), curvature(n.generator_radius_mm), n.sweep_meridian_deg);
    case SurfaceNumbers::Kind::conic:
      return ConicSurface{curvature(n.radius_mm), n.conic_constant};
    default:
      return SphereSurface{curvature(n.radius_mm)};
  }
}

Json surface_json(const SurfaceNumbers& n) {
  switch (n.kind) {
    case SurfaceNumbers::Kind::torus:
      return {{"type", "torus"},
              {"sweep_radius_mm", number_or_null(n.radius_mm)},
              {"generator_radius_mm", number_or_null(n.generator_radius_mm)},
              {"sweep_meridian_deg", n.sweep_meridian_deg}};
    case SurfaceNumbers::Kind::conic:
      return {{"type", "conic"}, {"radius_mm", number_or_null(n.radius_mm)}, {"conic_constant", n.conic_constant}};
    default:
      return {{"type", "sphere"}, {"radius_mm", number_or_null(n.radius_mm)}};
  }
}

Json mounting_json(const MountingNumbers& n) {
  return {{"decentration_mm", {n.right_mm, n.up_mm}},
          {"pantoscopic_tilt_deg", n.pantoscopic_tilt_deg},
          {"wrap_deg", n.wrap_deg}};
}

Mounting mounting_of(const MountingNumbers& n) {
  return {metres_per_millimetre * Eigen::Vector2d(n.right_mm, n.up_mm), radians_per_degree * n.pantoscopic_tilt_deg,
          radians_per_degree * n.wrap_deg};
}

Json lens_json(const LensNumbers& n, const FreeFormLenses& free_forms) {
  Json stands = {{"vertex_distance_mm", n.vertex_distance_mm}};
  if (n.mounting != MountingNumbers()) stands["mounting"] = mounting_json(n.mounting);
  if (n.free_form) return free_forms.document(*n.free_form, stands);
  Json j = {{"center_thickness_mm", n.center_thickness_mm},
            {"refractive_index", n.refractive_index},
            {"diameter_mm", n.diameter_mm}};
  j.update(stands);
  if (!n.made) {
    j["back"] = surface_json(n.back);
    j["front"] = surface_json(n.front);
    return j;
  }
  j["base_curve_D"] = n.made->base_curve_D;
  j["prescription"] = {{"sphere_D", n.made->sphere_D},
                       {"cylinder_D", n.made->cylinder_D},
                       {"axis_deg", n.made->axis_deg},
                       {"prism_cm_per_m", n.made->prism_cm_per_m},
                       {"prism_base_deg", n.made->prism_base_deg}};
  return {{"single_vision", std::move(j)}};
}

Json accommodation_json(const CaseNumbers& n) {
  if (n.mode == CaseNumbers::Mode::fixed) return {{"mode", "fixed"}, {"power_D", n.accommodation_D}};
  if (n.mode == CaseNumbers::Mode::best) return {{"mode", "best"}, {"amplitude_D", n.accommodation_D}};
  return {{"mode", "relaxed"}};
}

Accommodation accommodation_of(const CaseNumbers& n) {
  if (n.mode == CaseNumbers::Mode::fixed) return FixedAccommodation{n.accommodation_D, 0.0};
  if (n.mode == CaseNumbers::Mode::best) return BestAccommodation{n.accommodation_D};
  return RelaxedAccommodation{};
}

}  // namespace

std::optional<Eye> eye_of(const CaseNumbers& n) {
  try {
    Eye eye = Eye::with({n.sphere_D, n.cylinder_D, n.axis_deg, metres_per_millimetre * n.rx_vertex_distance_mm},
                        metres_per_millimetre * n.pupil_diameter_mm, accommodation_of(n));
    eye.rotation_center_m = metres_per_millimetre * n.rotation_center_mm;
    return eye;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

Spectacles spectacles_of(const LensNumbers& n, const FreeFormLenses& free_forms) {
  const double vertex_distance = metres_per_millimetre * n.vertex_distance_mm;
  if (n.free_form) {
    Spectacles lens = free_forms.lens(*n.free_form);
    lens.vertex_distance_m = vertex_distance;
    lens.mounting = mounting_of(n.mounting);
    return lens;
  }
  const double thickness = metres_per_millimetre * n.center_thickness_mm,
               diameter = metres_per_millimetre * n.diameter_mm;
  if (n.made)
    return single_vision(
        {.sphere_D = n.made->sphere_D,
         .cylinder_D = n.made->cylinder_D,
         .axis_deg = n.made->axis_deg,
         .vertex_distance_m = vertex_distance,
         .prism_cm_per_m = n.made->prism_cm_per_m,
         .prism_base_deg = n.made->prism_base_deg},
        {n.made->base_curve_D, thickness, n.refractive_index, vertex_distance, diameter, mounting_of(n.mounting)});
  Spectacles lens;
  lens.back = surface_of(n.back);
  lens.front = surface_of(n.front);
  lens.center_thickness_m = thickness;
  lens.refractive_index = n.refractive_index;
  lens.vertex_distance_m = vertex_distance;
  lens.diameter_m = diameter;
  lens.mounting = mounting_of(n.mounting);
  return lens;
}

Eigen::Vector3d gaze_of(const CaseNumbers& n) {
  return gaze_direction(radians_per_degree * n.azimuth_deg, radians_per_degree * n.elevation_deg);
}

Json query_json(const CaseNumbers& n, const FreeFormLenses& free_forms) {
  return {
      {"format", "sturm.ellipse/1"},
      {"eye",
       {{"prescription",
         {{"sphere_D", n.sphere_D},
          {"cylinder_D", n.cylinder_D},
          {"axis_deg", n.axis_deg},
          {"vertex_distance_mm", n.rx_vertex_distance_mm}}},
        {"pupil_diameter_mm", n.pupil_diameter_mm},
        {"rotation_center_mm", n.rotation_center_mm},
        {"accommodation", accommodation_json(n)}}},
      {"spectacles", n.lens ? lens_json(*n.lens, free_forms) : Json(nullptr)},
      {"targets",
       Json::array({{{"gaze_deg", {n.azimuth_deg, n.elevation_deg}}, {"distance_m", distance_json(n.distance_m)}}})},
      {"methods", {"conoid", "conoid_published"}}};
}

}  // namespace sturm::stress
