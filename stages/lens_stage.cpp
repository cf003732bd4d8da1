#include "stages/lens_stage.h"

#include "conoid/tracing/as_worn.h"
#include "io/json/values.h"
#include "lensmodel/edge_thickness.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"
#include "lensmodel/vertex_power.h"

namespace sturm {

namespace {

Json power_json(const std::optional<PowerMatrix>& power) {
  if (!power) return nullptr;
  const Prescription rx = power->as_prescription();  // minus-cylinder form
  return {{"matrix_D", symmetric_json(power->matrix())},
          {"sphere_D", number_or_null(rx.sphere_D)},
          {"cylinder_D", number_or_null(rx.cylinder_D)},
          {"axis_deg", rx.cylinder_D == 0.0 ? Json(nullptr) : number_or_null(rx.axis_deg)}};
}

/// Along the AXIS and across it: the higher power first.
Json with_principal_powers(const std::optional<PowerMatrix>& power) {
  Json result = power_json(power);
  if (power)
    result["principal_powers_D"] = {result["sphere_D"],
                                    result["sphere_D"].get<double>() + result["cylinder_D"].get<double>()};
  return result;
}

Json error_json(const std::optional<PowerMatrix>& worn, const std::optional<PowerMatrix>& nominal) {
  if (!worn || !nominal) return nullptr;
  const PowerMatrix error = *worn - *nominal;
  // The examiner's frame has the opposite sign of xy.
  const double J0 = 0.5 * (error.xx() - error.yy()), J45 = -error.xy();
  return {{"M_D", number_or_null(error.spherical_equivalent())},
          {"J0_D", number_or_null(J0)},
          {"J45_D", number_or_null(J45)},
          {"astigmatism_D", number_or_null(2.0 * std::hypot(J0, J45))}};
}

const char* name_of(EdgeStatus status) {
  switch (status) {
    case EdgeStatus::ok:
      return "ok";
    case EdgeStatus::surfaces_cross:
      return "surfaces_cross";
    default:
      return "surface_ends";
  }
}

Json thickness_json(const Spectacles& lens) {
  const EdgeThickness edge = edge_thickness(lens);
  const auto millimetres = [](double m) { return m / metres_per_millimetre; };
  return {{"center_mm", millimetres(lens.center_thickness_m)},
          {"edge_status", name_of(edge.status)},
          {"edge_min_mm", edge.rim ? Json(millimetres(edge.rim->min)) : Json(nullptr)},
          {"edge_max_mm", edge.rim ? Json(millimetres(edge.rim->max)) : Json(nullptr)},
          {"usable_diameter_mm", millimetres(edge.usable_diameter_m)}};
}

Json gaze_json(const LensQuery& query, const std::optional<PowerMatrix>& nominal, double azimuth_deg,
               double elevation_deg) {
  const AsWorn worn =
      as_worn(query.lens, gaze_direction(radians_per_degree * azimuth_deg, radians_per_degree * elevation_deg),
              query.rotation_center_m);
  Json result = {{"gaze_deg", {azimuth_deg, elevation_deg}}, {"status", name_of(worn.status)}};
  if (worn.status != LensStatus::ok) {
    for (const char* key : {"prism", "power", "error"}) result[key] = nullptr;
    return result;
  }
  // Steep lenses can bend a ray by a right angle and more; it has no prism then.
  const bool forward = worn.deviation_rad < 90.0 * radians_per_degree;
  result["prism"] = {
      {"deviation_deg", worn.deviation_rad / radians_per_degree},
      {"prism_cm_per_m", forward ? Json(worn.prism_cm_per_m()) : Json(nullptr)},
      {"chromatic_cm_per_m",
       forward && query.material ? Json(worn.prism_cm_per_m() / query.material->abbe_number) : Json(nullptr)},
      {"base_deg", number_or_null(worn.base_deg)}};
  result["power"] = power_json(worn.power);
  result["error"] = error_json(worn.power, nominal);
  if (!worn.power) result["status"] = "undefined";
  return result;
}

Json material_json(const std::optional<LensMaterial>& material) {
  if (!material) return nullptr;
  return {{"name", material->name}, {"abbe_number", material->abbe_number}};
}

Json fits_json(const std::vector<FreeFormFit>& fits) {
  constexpr double micrometres = 1e6;
  Json result = Json::array();
  for (const FreeFormFit& fit : fits)
    result.push_back(
        {{"side", fit.side},
         {"knot_spacing_mm",
          {fit.knot_spacing.x() / metres_per_millimetre, fit.knot_spacing.y() / metres_per_millimetre}},
         {"height_residual_um",
          fit.height ? Json{{"rms", micrometres * fit.height->rms}, {"max", micrometres * fit.height->max}}
                     : Json(nullptr)},
         {"power_residual_D",
          fit.power ? Json{{"mean", fit.power->mean_D}, {"cylinder", fit.power->cylinder_D}} : Json(nullptr)}});
  return result;
}

}  // namespace

Json lens_report(const LensQuery& query) {
  const Spectacles& lens = query.lens;
  const VertexPower power = vertex_power(lens);
  Json gazes = Json::array();
  for (const double elevation : query.elevations_deg)
    for (const double azimuth : query.azimuths_deg)
      gazes.push_back(gaze_json(query, power.back_vertex, azimuth, elevation));
  return {{"format", "sturm.lens_report/1"},
          {"refractive_index", lens.refractive_index},
          {"material", material_json(query.material)},
          {"vertex_distance_mm", lens.vertex_distance_m / metres_per_millimetre},
          {"diameter_mm", lens.diameter_m / metres_per_millimetre},
          {"rotation_center_mm", query.rotation_center_m / metres_per_millimetre},
          {"front", with_principal_powers(power.front)},
          {"back", with_principal_powers(power.back)},
          {"back_vertex", with_principal_powers(power.back_vertex)},
          {"thickness", thickness_json(lens)},
          {"free_form", fits_json(query.fits)},
          {"gazes", std::move(gazes)}};
}

}  // namespace sturm
