#include <nlohmann/json.hpp>

#include "app/comparison.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Json part_json(const PictureComparison& pictures, const PartResult& part) {
  Json values = Json::object(), floor = Json::object(), z = Json::object(), distinguishable = Json::object();
  bool noise = false;
  for (std::size_t i = 0; i < part.metrics.size(); ++i) {
    const std::string& key = pictures.metrics[i].key;
    const MetricResult& m = part.metrics[i];
    values[key] = number_or_null(m.value);
    if (!m.noise) continue;
    noise = true;
    floor[key] = number_or_null(m.noise->value);
    z[key] = number_or_null(m.noise->z);
    distinguishable[key] = m.distinguishable ? Json(*m.distinguishable) : Json(nullptr);
  }
  Json part_object = {{"pixels", part.pixels}, {"metrics", std::move(values)}, {"noise", nullptr}};
  if (noise)
    part_object["noise"] = {
        {"floor", std::move(floor)}, {"z", std::move(z)}, {"distinguishable", std::move(distinguishable)}};
  return part_object;
}

Json edge_json(const EdgeMtf& edge) {
  return {{"tilt_deg", edge.tilt_deg}, {"steep", edge.steep}, {"step", edge.step}, {"mtf", edge.mtf}};
}

Json psf_json(const PsfSummary& s) {
  const auto value_and_error = [](const WithError& e) {
    return Json{{"value", e.value}, {"standard_error", number_or_null(e.standard_error)}};
  };
  Json energy = Json::array(), mtf = Json::array();
  for (const WithError& e : s.encircled_energy) energy.push_back(value_and_error(e));
  for (const auto& direction : s.mtf) {
    Json row = Json::array();
    for (const auto& e : direction) row.push_back(e ? value_and_error(*e) : Json(nullptr));
    mtf.push_back(std::move(row));
  }
  return {{"centroid_arcmin", json_of(s.centroid)},
          {"covariance_arcmin2", symmetric_json(s.covariance)},
          {"radius_50_arcmin", value_and_error(s.radius_50)},
          {"radius_80_arcmin", value_and_error(s.radius_80)},
          {"encircled_energy", std::move(energy)},
          {"mtf", std::move(mtf)}};
}

Json psf_json(const PsfComparison& c) {
  return {{"test", psf_json(c.test)},
          {"reference", psf_json(c.reference)},
          {"radii_arcmin", c.radii_arcmin},
          {"frequencies_cpd", report_frequencies_cpd},
          {"directions_deg", report_directions_deg},
          {"shift_arcmin", json_of(c.shift)},
          {"total_variation",
           {{"value", c.total_variation.value},
            {"expected_of_noise", number_or_null(c.total_variation.expected_of_noise)}}},
          {"cell_arcmin", c.cell_arcmin},
          {"sliced_wasserstein_arcmin", c.sliced_wasserstein},
          {"largest_mtf_difference", c.largest_mtf_difference}};
}

const char* word_of(PixelValues values) {
  return values == PixelValues::Display ? "display" : "linear";
}

}  // namespace

Json json_of(const Comparison& c, const CompareOptions& options) {
  const ExposureRange& hdr = *c.settings.hdr_exposures;
  const Json whole = part_json(c.pictures, c.pictures.parts.front());
  Json document = {
      {"format", "sturm.comparison/1"},
      {"test", options.test},
      {"reference", options.reference},
      {"notes", c.notes},
      {"conditions",
       {{"test_values", word_of(c.test_file.values)},
        {"test_layer", c.test_file.layer},
        {"reference_values", word_of(c.reference_file.values)},
        {"reference_layer", c.reference_file.layer},
        {"exposure", c.settings.exposure},
        {"pixels_per_degree", c.settings.pixels_per_degree},
        {"hdr_exposures", {{"start_stops", hdr.start_stops}, {"stop_stops", hdr.stop_stops}, {"count", hdr.count}}},
        {"noise_files", options.noise},
        {"noise_tests", c.pictures.tests},
        {"noise_family_level", noise_family_level},
        {"noise_z_threshold", number_or_null(c.pictures.z_threshold)}}},
      {"metrics", whole["metrics"]},
      {"noise", whole["noise"]},
      {"regions", nullptr},
      {"regions_note", c.regions_note ? Json(*c.regions_note) : Json(nullptr)},
      {"slanted_edge", nullptr},
      {"psf", nullptr},
      {"bounds", c.bounds},
      {"passed", c.passed()}};
  if (options.regions) {
    document["regions"] = Json::object();
    for (std::size_t i = 1; i < c.pictures.parts.size(); ++i)
      document["regions"][c.pictures.parts[i].name] = part_json(c.pictures, c.pictures.parts[i]);
  }
  if (c.edge)
    document["slanted_edge"] = {{"area_px", options.edge},
                                {"frequencies_per_px", c.edge->test.frequencies},
                                {"test", edge_json(c.edge->test)},
                                {"reference", edge_json(c.edge->reference)}};
  if (c.psf) document["psf"] = psf_json(*c.psf);
  return document;
}

}  // namespace sturm
