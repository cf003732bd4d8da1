#include "compare/findings/picture_json.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Json json_of(const Estimate& measured) {
  return {{"value", number_or_null(measured.value)}, {"uncertainty", number_or_null(measured.uncertainty)}};
}

Estimate measured_at(const Json& json, std::string_view path) {
  const Json& value = value_at(json, path);
  return {number_at(value, "value"), number_at(value, "uncertainty")};
}

Json json_of(const std::map<std::string, Number>& numbers) {
  Json json = Json::object();
  for (const auto& [key, number] : numbers) json[key] = number_or_null(number);
  return json;
}

std::map<std::string, Number> numbers_of(const Json& json) {
  std::map<std::string, Number> numbers;
  if (json.is_object())
    for (const auto& [key, number] : json.items()) numbers[key] = number_at(number, "");
  return numbers;
}

Json json_of(const PictureMetric& metric) {
  if (!metric.has_error) return number_or_null(metric.value);
  Json json = json_of(Estimate{metric.value, metric.uncertainty});
  if (metric.degrees) json["degrees"] = *metric.degrees;
  return json;
}

PictureMetric metric_of(const Json& json) {
  if (!json.is_object()) return {.value = number_at(json, "")};
  return {.value = number_at(json, "value"),
          .has_error = true,
          .uncertainty = number_at(json, "uncertainty"),
          .degrees = number_at(json, "degrees")};
}

std::map<std::string, PictureMetric> metrics_of(const Json& json) {
  std::map<std::string, PictureMetric> metrics;
  if (json.is_object())
    for (const auto& [key, metric] : json.items()) metrics[key] = metric_of(metric);
  return metrics;
}

Json json_of(const PictureNoiseFloor& floor) {
  return {{"noise_floor", json_of(floor.metrics)},
          {"noise_floor_uncertainty", floor.uncertainties.empty() ? Json(nullptr) : json_of(floor.uncertainties)}};
}

PictureNoiseFloor noise_floor_of(const Json& entry) {
  return {numbers_of(value_at(entry, "noise_floor")), numbers_of(value_at(entry, "noise_floor_uncertainty"))};
}

PictureFiles files_of(const Json& entry, const std::string& name) {
  return {text_at(entry, "files/" + name), text_at(entry, "files/" + name + "_png")};
}

Json json_of(const PartErrors& part) {
  return {{"name", part.name},
          {"pixels", count_or_null(part.pixels)},
          {"ssim_display", part.ssim ? json_of(*part.ssim) : Json(nullptr)},
          {"rmse_display", json_of(part.rmse)},
          {"mean_square_display", json_of(part.mean_square)},
          {"noise_display", number_or_null(part.reference_noise)},
          {"prediction_noise_display", number_or_null(part.prediction_noise)},
          {"share_of_squared_error", number_or_null(part.share_of_squared_error)}};
}

PartErrors part_of(const Json& json) {
  PartErrors part;
  part.name = text_at(json, "name");
  part.pixels = count_at(json, "pixels");
  if (value_at(json, "ssim_display").is_object()) part.ssim = measured_at(json, "ssim_display");
  part.rmse = measured_at(json, "rmse_display");
  part.mean_square = measured_at(json, "mean_square_display");
  part.reference_noise = number_at(json, "noise_display");
  part.prediction_noise = number_at(json, "prediction_noise_display");
  part.share_of_squared_error = number_at(json, "share_of_squared_error");
  return part;
}

Json json_of(const CauseShares& cause) {
  return {{"name", cause.name},
          {"pixels", count_or_null(cause.pixels)},
          {"share_of_squared_error", number_or_null(cause.squared_error)},
          {"share_of_prediction_noise", number_or_null(cause.prediction_noise)},
          {"share_of_similarity_loss", number_or_null(cause.similarity_loss)}};
}

CauseShares cause_of(const Json& json) {
  return {text_at(json, "name"), count_at(json, "pixels"), number_at(json, "share_of_squared_error"),
          number_at(json, "share_of_prediction_noise"), number_at(json, "share_of_similarity_loss")};
}

ErrorBudget budget_at(const Json& json, std::string_view path) {
  const Json& budget = value_at(json, path);
  return {number_at(budget, "total"), number_at(budget, "reference_noise"), number_at(budget, "prediction_noise"),
          number_at(budget, "method")};
}

/// A prediction by region, an element of "predictions".
Json json_of(const PredictionFinding& prediction) {
  Json parts = Json::array(), causes = Json::array();
  for (const PartErrors& part : prediction.parts) parts.push_back(json_of(part));
  for (const CauseShares& cause : prediction.causes) causes.push_back(json_of(cause));
  const ErrorBudget &loss = prediction.similarity_loss, &error = prediction.squared_error;
  Json json = {{"kind", prediction.kind ? name_of(*prediction.kind) : ""},
               {"files", {{"predicted", prediction.files.exr}, {"predicted_png", prediction.files.png}}},
               {"seconds", json_of(prediction.seconds)},
               {"parts", std::move(parts)},
               {"causes", std::move(causes)},
               {"similarity_loss",
                {{"total", number_or_null(loss.total)},
                 {"reference_noise", number_or_null(loss.reference_noise)},
                 {"prediction_noise", number_or_null(loss.prediction_noise)},
                 {"method", number_or_null(loss.method)}}},
               {"squared_error",
                {{"total", number_or_null(error.total)},
                 {"prediction_noise", number_or_null(error.prediction_noise)},
                 {"method", number_or_null(error.method)}}},
               {"samples_of_equal_error", number_or_null(prediction.samples_of_equal_error)},
               {"times_faster", number_or_null(prediction.times_faster)},
               {"cost_in_paths", number_or_null(prediction.cost_in_paths)},
               {"rmse_needed", number_or_null(prediction.rmse_needed)}};
  if (prediction.kind == PredictionKind::DepthPsf) json["psf"] = seen_psf_words.word_of(prediction.psf);
  if (prediction.layer_sum) json["layer_sum"] = true;
  return json;
}

PredictionFinding prediction_of(const Json& json) {
  PredictionFinding prediction;
  prediction.kind = prediction_kind_words.value_of(text_at(json, "kind"));
  prediction.psf = seen_psf_words.value_of(text_at(json, "psf")).value_or(SeenPsf::Rays);
  prediction.layer_sum = boolean_at(json, "layer_sum").value_or(false);
  prediction.files = files_of(json, "predicted");
  prediction.seconds = numbers_of(value_at(json, "seconds"));
  for (const Json& part : array_at(json, "parts")) prediction.parts.push_back(part_of(part));
  for (const Json& cause : array_at(json, "causes")) prediction.causes.push_back(cause_of(cause));
  prediction.similarity_loss = budget_at(json, "similarity_loss");
  prediction.squared_error = budget_at(json, "squared_error");
  prediction.samples_of_equal_error = number_at(json, "samples_of_equal_error");
  prediction.times_faster = number_at(json, "times_faster");
  prediction.cost_in_paths = number_at(json, "cost_in_paths");
  prediction.rmse_needed = number_at(json, "rmse_needed");
  return prediction;
}

/// "images" have one prediction, whose members stand beside those of the path-traced picture.
Json image_json(const PictureFinding& finding) {
  const PredictionFinding prediction = finding.prediction();
  Json metrics = Json::object();
  for (const auto& [key, metric] : prediction.metrics) metrics[key] = json_of(metric);
  Json json = json_of(finding.noise_floor);
  json.update({{"id", finding.id},
               {"scene", finding.scene},
               {"prescription", finding.prescription},
               {"pupil_mm", number_or_null(finding.pupil_mm)},
               {"ray_model", finding.model()},
               {"files",
                {{"path_traced", finding.path_traced.exr},
                 {"path_traced_png", finding.path_traced.png},
                 {"predicted", prediction.files.exr},
                 {"predicted_png", prediction.files.png}}},
               {"seconds",
                {{"path_traced", number_or_null(finding.seconds_path_traced)},
                 {"sharp_view", number_or_null(prediction.seconds_of("sharp_view"))},
                 {"spreading", number_or_null(prediction.seconds_of("spreading"))},
                 {"predicted_total", number_or_null(prediction.seconds_of("total"))}}},
               {"samples_per_pixel", count_or_null(finding.samples_per_pixel)},
               {"metrics", std::move(metrics)}});
  if (!finding.same_view_as.empty()) json["same_view_as"] = finding.same_view_as;
  for (const auto& [mutation, mutated] : finding.mutated) json["mutated"][mutation] = image_json(mutated);
  return json;
}

void read_image(const Json& entry, PictureFinding& finding) {
  finding.prescription = text_at(entry, "prescription");
  finding.ray_model = ray_model_named(text_at(entry, "ray_model"));
  finding.seconds_path_traced = number_at(entry, "seconds/path_traced");
  finding.samples_per_pixel = count_at(entry, "samples_per_pixel");
  finding.same_view_as = text_at(entry, "same_view_as");
  PredictionFinding prediction;
  prediction.kind = PredictionKind::Ellipses;
  prediction.files = files_of(entry, "predicted");
  prediction.seconds = {{"sharp_view", number_at(entry, "seconds/sharp_view")},
                        {"spreading", number_at(entry, "seconds/spreading")},
                        {"total", number_at(entry, "seconds/predicted_total")}};
  prediction.metrics = metrics_of(value_at(entry, "metrics"));
  finding.predictions = {std::move(prediction)};
  const Json& mutated = value_at(entry, "mutated");
  if (mutated.is_object())
    for (const auto& [mutation, other] : mutated.items())
      finding.mutated.emplace(mutation, picture_finding(other, PictureMeasures::Metrics, finding.replicates));
}

Json json_of(const PathTracingCost& cost) {
  const auto pair = [](const std::array<Number, 2>& numbers) {
    return Json{number_or_null(numbers[0]), number_or_null(numbers[1])};
  };
  return {{"samples_per_pixel", pair(cost.samples_per_pixel)},
          {"seconds", pair(cost.seconds)},
          {"rmse_display", pair(cost.rmse)},
          {"order", number_or_null(cost.order)}};
}

PathTracingCost cost_of(const Json& json) {
  const auto pair = [&](const std::string& key) {
    return std::array{number_at(json, key + "/0"), number_at(json, key + "/1")};
  };
  return {pair("samples_per_pixel"), pair("seconds"), pair("rmse_display"), number_at(json, "order")};
}

/// Samples as the entry states them: of each replicate.
Json region_json(const PictureFinding& finding) {
  const bool sampled = finding.samples_per_pixel && finding.replicates && *finding.replicates > 0;
  Json predictions = Json::array();
  for (const PredictionFinding& prediction : finding.predictions) predictions.push_back(json_of(prediction));
  Json json = json_of(finding.noise_floor);
  json.update({{"id", finding.id},
               {"note", finding.note},
               {"scene", finding.scene},
               {"gaze", finding.gaze},
               {"spectacles", finding.spectacles ? Json(*finding.spectacles) : Json(nullptr)},
               {"pupil_mm", number_or_null(finding.pupil_mm)},
               {"resolution", {count_or_null(finding.resolution[0]), count_or_null(finding.resolution[1])}},
               {"files", {{"path_traced", finding.path_traced.exr}, {"path_traced_png", finding.path_traced.png}}},
               {"samples_per_pixel", sampled ? Json(*finding.samples_per_pixel / *finding.replicates) : Json(nullptr)},
               {"replicates", count_or_null(finding.replicates)},
               {"sharp_samples_per_pixel", count_or_null(finding.sharp_samples_per_pixel)},
               {"seconds_path_traced", number_or_null(finding.seconds_path_traced)},
               {"path_tracing", json_of(finding.cost)},
               {"predictions", std::move(predictions)}});
  if (finding.ray_model != RayModel::power_matrix) json["ray_model"] = finding.model();
  for (const auto& [mutation, mutated] : finding.mutated) json["mutated"][mutation] = region_json(mutated);
  return json;
}

void read_regions(const Json& entry, PictureFinding& finding) {
  finding.ray_model = ray_model_named(text_at(entry, "ray_model"));
  if (!finding.ray_model) finding.ray_model = RayModel::power_matrix;
  finding.note = text_at(entry, "note");
  finding.gaze = text_at(entry, "gaze");
  finding.spectacles = boolean_at(entry, "spectacles");
  finding.resolution = {count_at(entry, "resolution/0"), count_at(entry, "resolution/1")};
  finding.replicates = count_at(entry, "replicates");
  if (const auto each = count_at(entry, "samples_per_pixel"); each && finding.replicates)
    finding.samples_per_pixel = *each * *finding.replicates;
  finding.sharp_samples_per_pixel = count_at(entry, "sharp_samples_per_pixel");
  finding.seconds_path_traced = number_at(entry, "seconds_path_traced");
  finding.cost = cost_of(value_at(entry, "path_tracing"));
  for (const Json& prediction : array_at(entry, "predictions"))
    finding.predictions.push_back(prediction_of(prediction));
}

/// As the report's experiment states them.
std::optional<std::uint64_t> replicates_of_image(const Json& report, const std::string& id) {
  for (const Json& image : array_at(report, "spec/images"))
    if (text_at(image, "id") == id) return count_at(image, "replicates");
  return std::nullopt;
}

}  // namespace

Json to_json(const PictureFinding& finding) {
  return finding.measures == PictureMeasures::Metrics ? image_json(finding) : region_json(finding);
}

PictureFinding picture_finding(const Json& entry, PictureMeasures measures, std::optional<std::uint64_t> replicates) {
  PictureFinding finding;
  finding.measures = measures;
  finding.id = text_at(entry, "id");
  finding.scene = text_at(entry, "scene");
  finding.pupil_mm = number_at(entry, "pupil_mm");
  finding.path_traced = files_of(entry, "path_traced");
  finding.replicates = replicates;
  finding.noise_floor = noise_floor_of(entry);
  if (measures == PictureMeasures::Metrics)
    read_image(entry, finding);
  else
    read_regions(entry, finding);
  return finding;
}

std::vector<PictureFinding> picture_findings(const Json& report) {
  std::vector<PictureFinding> findings;
  for (const PictureMeasures measures : picture_measures)
    for (const Json& entry : array_at(report, list_name(measures)))
      findings.push_back(picture_finding(entry, measures, replicates_of_image(report, text_at(entry, "id"))));
  return findings;
}

}  // namespace sturm
