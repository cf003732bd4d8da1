#include "compare/findings/psfs.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Json json_of(const std::optional<Ellipse>& e) {
  if (!e) return nullptr;
  return {{"semi_axes_arcmin", pair_or_null(Eigen::Vector2d(e->semi_major, e->semi_minor))},
          {"orientation_deg", number_or_null(e->orientation_deg)}};
}

Json json_of(const std::optional<MeasuredSpot>& spot) {
  if (!spot) return nullptr;
  Json json = {{"hits", number_or_null(spot->hits)},
               {"centroid_arcmin", pair_or_null(spot->centroid_arcmin)},
               {"centroid_standard_error_arcmin", pair_or_null(spot->centroid_standard_error_arcmin)},
               {"standard_error_arcmin", pair_or_null(spot->standard_error_arcmin)}};
  if (spot->ellipse) json.update(json_of(spot->ellipse));
  return json;
}

Json json_of(const PsfFinding& psf) {
  Json json = {{"id", psf.id},
               {"prescription", psf.prescription},
               {"distance_m", distance_or_null(psf.distance_m)},
               {"pupil_mm", number_or_null(psf.pupil_mm)},
               {"ray_model", name_of(psf.ray_model)},
               {"file", psf.file},
               {"files", {{"predicted", psf.predicted_file}}},
               {"pixel_arcmin", number_or_null(psf.pixel_arcmin)},
               {"resolution", count_or_null(psf.resolution)},
               {"predicted", json_of(psf.predicted)},
               {"measured", json_of(psf.measured)},
               {"bundle", json_of(psf.bundle)}};
  for (const auto& [mutation, other] : psf.mutated) json["mutated"][mutation] = json_of(other);
  return json;
}

std::optional<Ellipse> ellipse_in_arcminutes(const Json& json) {
  const std::optional<Eigen::Vector2d> axes = pair_at(json, "semi_axes_arcmin");
  if (!axes) return std::nullopt;
  return Ellipse{axes->x(), axes->y(), number_at(json, "orientation_deg")};
}

std::optional<MeasuredSpot> spot_from(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  return MeasuredSpot{.ellipse = ellipse_in_arcminutes(json),
                      .standard_error_arcmin = pair_at(json, "standard_error_arcmin"),
                      .centroid_arcmin = pair_at(json, "centroid_arcmin"),
                      .centroid_standard_error_arcmin = pair_at(json, "centroid_standard_error_arcmin"),
                      .hits = number_at(json, "hits")};
}

PsfFinding psf_finding_from(const Json& json) {
  return {.id = text_at(json, "id"),
          .prescription = text_at(json, "prescription"),
          .distance_m = distance_at(json, "distance_m"),
          .pupil_mm = number_at(json, "pupil_mm"),
          .ray_model = ray_model_at(json, "ray_model"),
          .file = text_at(json, "file"),
          .predicted_file = text_at(json, "files/predicted"),
          .pixel_arcmin = number_at(json, "pixel_arcmin"),
          .resolution = count_at(json, "resolution"),
          .predicted = ellipse_in_arcminutes(value_at(json, "predicted")),
          .measured = spot_from(value_at(json, "measured")),
          .bundle = ellipse_in_arcminutes(value_at(json, "bundle")),
          .mutated = {}};
}

}  // namespace

Json to_json(const std::vector<PsfFinding>& psfs) {
  Json list = Json::array();
  for (const PsfFinding& psf : psfs) list.push_back(json_of(psf));
  return list;
}

std::vector<PsfFinding> read_psfs(const Json& report) {
  std::vector<PsfFinding> psfs;
  for (const Json& entry : array_at(report, "psfs")) psfs.push_back(psf_finding_from(entry));
  return psfs;
}

}  // namespace sturm
