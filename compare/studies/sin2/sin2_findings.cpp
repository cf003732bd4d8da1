#include "compare/studies/sin2/sin2_findings.h"

#include "compare/studies/stored_words.h"

namespace sturm {

template <>
inline constexpr auto record_members<Sin2Conditions> =
    std::tuple{member("eyes", &Sin2Conditions::eyes),
               member("grid_eyes", &Sin2Conditions::grid_eyes),
               member("real_eyes", &Sin2Conditions::real_eyes),
               member("distances_m", &Sin2Conditions::distances_m),
               member("pupil_diameters_mm", &Sin2Conditions::pupil_diameters_mm),
               member("accommodations", &Sin2Conditions::accommodations),
               member("radial", &Sin2Conditions::radial),
               member("azimuthal", &Sin2Conditions::azimuthal),
               member("rings", &Sin2Conditions::rings),
               member("angle_factor", &Sin2Conditions::angle_factor),
               member("reference_distance_m", &Sin2Conditions::reference_distance_m),
               member("reference_pupil_mm", &Sin2Conditions::reference_pupil_mm),
               member("gallery_rays", &Sin2Conditions::gallery_rays)};

template <>
inline constexpr auto record_members<Sin2ModelRow> =
    std::tuple{member("ray_model", &Sin2ModelRow::ray_model),
               member("title", &Sin2ModelRow::title),
               member("cases", &Sin2ModelRow::cases),
               member("undefined", &Sin2ModelRow::undefined),
               member("pole", &Sin2ModelRow::pole),
               member("rays", &Sin2ModelRow::rays),
               member("rays_dropped", &Sin2ModelRow::rays_dropped),
               member("rays_negative_focus", &Sin2ModelRow::rays_negative_focus),
               member("largest_error_D", &Sin2ModelRow::largest_error_D),
               member("largest_error_case", &Sin2ModelRow::largest_error_case)};

template <>
inline constexpr auto record_members<Sin2Check> =
    std::tuple{member("value", &Sin2Check::value), member("cases", &Sin2Check::cases),
               member("worst_case", &Sin2Check::worst_case)};

template <>
inline constexpr auto record_members<Distribution> = std::tuple{
    member("median", &Distribution::median), member("p90", &Distribution::p90), member("max", &Distribution::max)};

template <>
inline constexpr auto record_members<Sin2PopulationRow> =
    std::tuple{member("ray_model", &Sin2PopulationRow::ray_model),
               member("accommodation", &Sin2PopulationRow::accommodation),
               member("distance_m", &Sin2PopulationRow::distance_m),
               member("eyes", &Sin2PopulationRow::eyes),
               member("pole", &Sin2PopulationRow::pole),
               member("noticeable", &Sin2PopulationRow::noticeable),
               member("error_D", &Sin2PopulationRow::error_D),
               member("error_arcmin", &Sin2PopulationRow::error_arcmin),
               member("error_percent", &Sin2PopulationRow::error_percent)};

template <>
inline constexpr auto record_members<Sin2Map> =
    std::tuple{member("ray_model", &Sin2Map::ray_model), member("error_D", &Sin2Map::error_D)};

template <>
inline constexpr auto record_members<Sin2Curve> =
    std::tuple{member("ray_model", &Sin2Curve::ray_model), member("points", &Sin2Curve::points)};

template <>
inline constexpr auto record_members<Sin2Cumulative> =
    std::tuple{member("ray_model", &Sin2Cumulative::ray_model), member("error_D", &Sin2Cumulative::error_D)};

template <>
inline constexpr auto record_members<Sin2ReferenceView> =
    std::tuple{member("spheres_D", &Sin2ReferenceView::spheres_D),
               member("cylinders_D", &Sin2ReferenceView::cylinders_D), member("maps", &Sin2ReferenceView::maps),
               member("curves", &Sin2ReferenceView::curves), member("cumulative", &Sin2ReferenceView::cumulative)};

template <>
inline constexpr auto record_members<Sin2Spread> = std::tuple{
    member("model", &Sin2Spread::model),
    member("total_variation", &Sin2Spread::total_variation),
    member("total_variation_over_noise", &Sin2Spread::total_variation_over_noise),
    member("radius_50_arcmin", &Sin2Spread::radius_50_arcmin),
    member("radius_80_arcmin", &Sin2Spread::radius_80_arcmin),
    member("radius_50_error_of_independent_rays_arcmin", &Sin2Spread::radius_50_error_of_independent_rays_arcmin),
    member("radius_80_error_of_independent_rays_arcmin", &Sin2Spread::radius_80_error_of_independent_rays_arcmin),
    member("file", &Sin2Spread::file)};

template <>
inline constexpr auto record_members<Sin2GalleryEntry> =
    std::tuple{member("id", &Sin2GalleryEntry::id),
               member("title", &Sin2GalleryEntry::title),
               member("sphere_D", &Sin2GalleryEntry::sphere_D),
               member("cylinder_D", &Sin2GalleryEntry::cylinder_D),
               member("axis_deg", &Sin2GalleryEntry::axis_deg),
               member("distance_m", &Sin2GalleryEntry::distance_m),
               member("pupil_mm", &Sin2GalleryEntry::pupil_mm),
               member("accommodation_D", &Sin2GalleryEntry::accommodation_D),
               member("half_side_arcmin", &Sin2GalleryEntry::half_side_arcmin),
               member("cell_arcmin", &Sin2GalleryEntry::cell_arcmin, IfEmpty::LeftOut),
               member("noise_total_variation", &Sin2GalleryEntry::noise_total_variation, IfEmpty::LeftOut),
               member("models", &Sin2GalleryEntry::models)};

template <>
inline constexpr auto record_members<Sin2StudyFindings> =
    std::tuple{member("conditions", &Sin2StudyFindings::conditions),
               member("models", &Sin2StudyFindings::models),
               member("checks", &Sin2StudyFindings::checks),
               member("population", &Sin2StudyFindings::population),
               member("reference_view", &Sin2StudyFindings::reference_view),
               member("gallery", &Sin2StudyFindings::gallery)};

const Sin2Check* Sin2StudyFindings::check(const std::string& name) const {
  const auto found = checks.find(name);
  return found == checks.end() ? nullptr : &found->second;
}

const Sin2PopulationRow* Sin2StudyFindings::worst_views(RayModel model) const {
  for (const Sin2PopulationRow& row : population)
    if (row.ray_model == model && !row.accommodation) return &row;
  return nullptr;
}

Json to_json(const Sin2Checks& checks) {
  Json json = json_from(checks);
  // The one check that counts: a whole number.
  if (const auto counted = checks.find("cases"); counted != checks.end() && counted->second.value)
    json["cases"]["value"] = static_cast<std::int64_t>(*counted->second.value);
  return json;
}

Json to_json(const Sin2StudyFindings& findings) {
  Json json = json_from(findings);
  json["checks"] = to_json(findings.checks);
  return json;
}

std::optional<Sin2StudyFindings> sin2_study_findings(const Json& report) {
  return record_from<std::optional<Sin2StudyFindings>>(value_at(report, "sin2_study"));
}

Json to_json(const std::vector<Sin2ModelRow>& models) {
  return json_from(models);
}

Json to_json(const std::vector<Sin2PopulationRow>& population) {
  return json_from(population);
}

Json to_json(const Sin2ReferenceView& view) {
  return json_from(view);
}

Json to_json(const Sin2GalleryEntry& entry) {
  return json_from(entry);
}

Sin2GalleryEntry sin2_gallery_entry_from(const Json& json) {
  return record_from<Sin2GalleryEntry>(json);
}

}  // namespace sturm
