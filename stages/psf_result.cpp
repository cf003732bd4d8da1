#include <nlohmann/json.hpp>

#include "io/json/values.h"
#include "lensmodel/units.h"
#include "stages/psf_stage.h"

namespace sturm {

namespace {

constexpr double square = arcminutes_per_radian * arcminutes_per_radian;

Json arcmin(const Eigen::Vector2d& radians) {
  return json_of(Eigen::Vector2d(arcminutes_per_radian * radians));
}

Json target_json(const PsfSpec& spec, std::size_t index) {
  const PsfTarget& target = spec.targets[index];
  Json json = {{"target", index}, {"defocus_D", target.vergence_D}, {"accommodation_D", target.accommodation_D}};
  json["distance_m"] = target.distance_m ? distance_json(*target.distance_m) : Json(nullptr);
  return json;
}

Json radii_json(const PsfSpec& spec, const MeasuredSpread& spread) {
  const auto radius = [](const std::optional<double>& radians) {
    return radians ? number_or_null(arcminutes_per_radian * *radians) : Json(nullptr);
  };
  Json list = Json::array();
  for (std::size_t i = 0; i < spec.energy_shares.size(); ++i)
    list.push_back({{"share", spec.energy_shares[i]},
                    {"radius_about_chief_ray_arcmin", radius(spread.radii_about_chief_ray[i])},
                    {"radius_about_centroid_arcmin", radius(spread.radii_about_centroid[i])}});
  return list;
}

Json sampling_json(const std::optional<WaveSampling>& sampling) {
  if (!sampling) return nullptr;
  return {{"grid", sampling->grid},
          {"window_arcmin", arcminutes_per_radian * sampling->window_rad()},
          {"pixel_arcmin", arcminutes_per_radian * sampling->pixel_rad()}};
}

Json spread_json(const PsfSpec& spec, const MeasuredSpread& spread) {
  Json json = target_json(spec, spread.target);
  json["model"] = std::string(psf_model_words.word_of(spread.model));
  json["light"] = spec.lights[spread.light].id;
  json["strehl"] = number_or_null(spread.strehl_origin);
  json["strehl_peak"] = number_or_null(spread.strehl_peak);
  json["peak_arcmin"] = spread.peak ? arcmin(*spread.peak) : Json(nullptr);
  json["visual_strehl"] = number_or_null(spread.visual_strehl);
  json["mtf"] = spread.mtf;
  json["energy"] = radii_json(spec, spread);
  json["centroid_arcmin"] = arcmin(spread.centroid);
  json["covariance_arcmin2"] =
      spread.covariance ? symmetric_json(Eigen::Matrix2d(square * *spread.covariance)) : Json(nullptr);
  json["sampling"] = sampling_json(spread.sampling);
  return json;
}

}  // namespace

Json psf_result(const PsfSpec& spec, const PointSpreads& spreads) {
  Json result = {
      {"format", "sturm.psf_result/1"},
      {"pupil_diameter_mm", 2.0 * spec.eye.pupil_radius_m / metres_per_millimetre},
      {"stiles_crawford_per_mm2", spec.eye.stiles_crawford_per_m2 * metres_per_millimetre * metres_per_millimetre},
      {"in_focus_nm", spec.in_focus_nm},
      {"frame", spec.examiner_frame ? "examiner" : "wearer"},
      {"mtf", {{"frequencies_cpd", spec.frequencies_cpd}, {"directions_deg", spec.directions_deg}}},
      {"notes", spec.notes}};
  Json& lights = result["lights"] = Json::array();
  for (const NamedLight& light : spec.lights) {
    Json lines = Json::array();
    for (const SpectralLine& line : light.light)
      lines.push_back({{"wavelength_nm", line.wavelength_nm}, {"weight", line.weight}});
    lights.push_back({{"id", light.id}, {"lines", std::move(lines)}});
  }
  Json& list = result["results"] = Json::array();
  for (const MeasuredSpread& spread : spreads.spreads) list.push_back(spread_json(spec, spread));
  Json& comparisons = result["comparisons"] = Json::array();
  for (const PsfDistance& distance : spreads.distances) {
    Json json = target_json(spec, distance.target);
    json["light"] = spec.lights[distance.light].id;
    Json& cells = json["total_variation"] = Json::array();
    for (std::size_t i = 0; i < spec.cells_arcmin.size(); ++i)
      cells.push_back({{"cell_arcmin", spec.cells_arcmin[i]}, {"value", number_or_null(distance.total_variation[i])}});
    comparisons.push_back(std::move(json));
  }
  return result;
}

}  // namespace sturm
