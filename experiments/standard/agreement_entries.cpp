#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/images/regions.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "compare/statistics/equal_error.h"
#include "compare/studies/agreement/agreement_measures.h"
#include "compare/studies/agreement/agreement_reasons.h"
#include "experiments/run/replicates.h"
#include "experiments/run/sections.h"
#include "experiments/standard/noise_floor_error.h"
#include "io/images/tone_map.h"
#include "io/json/values.h"
#include "stages/image_files.h"
#include "stages/plan/camera_pose.h"
#include "stages/prediction_stage.h"
#include "stages/stopwatch.h"
#include "stages/view_layers.h"

namespace sturm {

namespace {

constexpr double exposure = 1.0;
constexpr std::uint64_t sharp_view_stream =
    0x41475245ull;                                     // the predictions' noise is independent of the path tracer's
constexpr std::uint64_t fewer_stream = 0x46455745ull;  // and so is that of its pictures of fewer samples
constexpr std::uint64_t fewer_divisor = 8;

/// Pictures of one view by one method, and the seconds of the fastest: other work on the machine only adds to a time.
struct Pictures {
  std::vector<Image> linear, display;
  std::map<std::string, double> seconds;

  void add(Image image, std::map<std::string, double> parts) {
    display.push_back(to_display(image, exposure));
    linear.push_back(std::move(image));
    double total = 0.0;
    for (const auto& [part, s] : parts) total += s;
    parts["total"] = total;
    if (seconds.empty() || total < seconds.at("total")) seconds = std::move(parts);
  }
};

double similarity_shown(const Image& a, const Image& b) {
  return ssim(to_display(a, exposure), to_display(b, exposure)).mean;
}

double rmse_shown(const Image& a, const Image& b) {
  return rmse(to_display(a, exposure), to_display(b, exposure));
}

Json measured(const ReplicateMean& mean) {
  return {{"value", mean.value}, {"uncertainty", mean.uncertainty}};
}

/// The first of some regions that holds each pixel: parts of the picture that do not overlap. Empty ones are left out.
std::vector<Region> first_of(std::vector<Region> regions) {
  std::vector<std::uint8_t> taken(regions.empty() ? 0 : regions.front().mask.pixels.size());
  for (Region& region : regions)
    for (std::size_t i = 0; i < taken.size(); ++i) {
      float& inside = region.mask.pixels[i];
      inside = inside > 0.0f && !taken[i] ? 1.0f : 0.0f;
      taken[i] = taken[i] || inside > 0.0f;
    }
  std::erase_if(regions, [](const Region& region) { return region.pixels() == 0; });
  return regions;
}

class Case {
 public:
  Case(const AgreementCase& spec, const Scene& scene, std::uint64_t seed) : spec_(spec), scene_(scene), seed_(seed) {}

  void path_trace_all(const ProgressFunction& progress) {
    const auto n = static_cast<int>(spec_.samples_per_pixel), fewer = std::max(1, n / static_cast<int>(fewer_divisor));
    const double of_fewer = static_cast<double>(fewer) / (fewer + n);
    const Pictures few = path_traced(fewer, seed_ ^ fewer_stream, [&](double f) { progress(f * of_fewer); });
    Pictures all = path_traced(n, seed_, [&](double f) { progress(of_fewer + f * (1.0 - of_fewer)); });
    fewer_ = {static_cast<double>(fewer), few.seconds.at("total"), ReplicatePictures(few.display).variance(nullptr)};
    traced_linear_ = std::move(all.linear);
    traced_.emplace(std::move(all.display));
    more_ = {static_cast<double>(n), all.seconds.at("total"), traced_->variance(nullptr)};
    layers_ = view_layers(scene_, sight_field(spec_.camera, spec_.worn, 0.0));
  }

  Pictures predict_all(const PredictionSpec& prediction) const {
    Pictures pictures;
    RenderSettings settings;
    settings.samples_per_pixel = static_cast<int>(spec_.sharp_samples_per_pixel);
    settings.max_bounces = spec_.max_bounces;
    for (int r = 0; r < spec_.replicates; ++r) {
      settings.seed = replicate_seed(seed_ ^ sharp_view_stream, r);
      if (prediction.kind == PredictionKind::Ellipses) {
        PredictedImage image =
            predict(scene_, camera_pose(spec_.camera), spec_.worn.eye, prediction.oversampling, settings);
        pictures.add(std::move(image.prediction.radiance),
                     {{"sharp_view", image.times.sharp_view_seconds}, {"spreading", image.times.spreading_seconds}});
      } else {
        PredictedView view = predict_view(scene_, spec_.camera, spec_.worn, 0.0, prediction, settings);
        pictures.add(std::move(view.layers.at("")), std::move(view.seconds));
      }
    }
    return pictures;
  }

  Json measured_against_traced(const Pictures& pictures) const {
    const ReplicatePictures predicted(pictures.display);
    const PredictionErrors errors(*traced_, predicted);
    const ErrorParts whole = errors.within(nullptr);
    const std::vector<Region> regions = regions_of_case(pictures.linear.front());
    Json parts = Json::array({part_json("whole", whole, whole, errors.similarity())});
    for (const Region& region : regions)
      if (region.pixels() > 0)
        parts.push_back(part_json(region.name, errors.within(&region.mask), whole, errors.similarity(region.mask)));
    Json result = time_json(whole, pictures.seconds.at("total"));
    const SimilarityLoss loss = errors.similarity_loss();
    result["seconds"] = pictures.seconds;
    result["parts"] = std::move(parts);
    result["causes"] = causes_json(errors, whole, regions);
    result["similarity_loss"] = {{"total", loss.total},
                                 {"reference_noise", loss.reference_noise},
                                 {"prediction_noise", loss.prediction_noise},
                                 {"method", loss.method}};
    result["squared_error"] = {
        {"total", whole.error}, {"prediction_noise", whole.prediction_noise}, {"method", whole.method()}};
    return result;
  }

  Image mean() const { return Replicates{traced_linear_}.mean(); }

  Json path_tracing() const {
    return {{"samples_per_pixel", {fewer_.samples, more_.samples}},
            {"seconds", {fewer_.seconds, more_.seconds}},
            {"rmse_display", {std::sqrt(fewer_.variance), std::sqrt(more_.variance)}},
            {"order", number_or_null(NoiseOverTime(fewer_, more_).order())}};
  }
  double seconds_path_traced() const { return more_.seconds; }

  /// SSIM and error of two halves of the replicates: what noise alone makes of a comparison with half of the samples
  /// each.
  Json noise_floor() const {
    const Replicates all{traced_linear_};
    const Image a = all.first_half(), b = all.second_half();
    return {{"ssim_display", similarity_shown(a, b)}, {"rmse_display", rmse_shown(a, b)}};
  }

  /// Its standard errors; null with fewer than four replicates.
  Json noise_floor_uncertainty() const {
    const Replicates all{traced_linear_};
    const auto similarity = noise_floor_error(all, similarity_shown), error = noise_floor_error(all, rmse_shown);
    return similarity && error ? Json{{"ssim_display", *similarity}, {"rmse_display", *error}} : Json(nullptr);
  }

 private:
  Pictures path_traced(int samples, std::uint64_t seed, const ProgressFunction& progress) const {
    RenderSpec view;
    view.camera = spec_.camera;
    view.ray_model = RayModel::power_matrix;
    ViewPlan plan;
    plan.naked =
        spec_.camera.gaze == Gaze::Camera && !spec_.worn.spectacles && spec_.worn.eye.stiles_crawford_per_m2 == 0.0;
    RenderSettings settings;
    settings.samples_per_pixel = samples;
    settings.max_bounces = spec_.max_bounces;
    settings.guide_emitters = true;
    Pictures pictures;
    for (int r = 0; r < spec_.replicates; ++r) {
      settings.seed = replicate_seed(seed, r);
      settings.progress = [&](double fraction) { progress((r + fraction) / spec_.replicates); };
      Stopwatch watch;
      Image image = path_trace_view(scene_, view, spec_.worn, 0.0, settings, plan).radiance;
      pictures.add(std::move(image), {{"path_tracing", watch.lap()}});
    }
    return pictures;
  }

  std::vector<Region> regions_of_case(const Image& predicted) const {
    std::vector<Region> regions = regions_of(predicted, mean(), exposure, {layers_.depth, layers_.blur_px});
    regions.push_back({"specular", layers_.specular});
    regions.push_back({"lamp_rims", layers_.lamp_rims});
    for (float& v : regions.back().mask.pixels) v = v > 0.0f ? 1.0f : 0.0f;
    return regions;
  }

  /// What a prediction of this error and time is worth in path tracing.
  Json time_json(const ErrorParts& whole, double seconds) const {
    const NoiseOverTime path_tracing(fewer_, more_);
    const auto samples = path_tracing.samples_for(whole.error);
    const double cost = seconds / path_tracing.seconds_per_sample();
    const auto needed = path_tracing.variance_of(speed_bar * cost);
    return {{"samples_of_equal_error", number_or_null(samples)},
            {"times_faster", samples ? Json(path_tracing.seconds_for(*samples) / seconds) : Json(nullptr)},
            {"cost_in_paths", cost},
            {"rmse_needed", needed ? Json(std::sqrt(*needed)) : Json(nullptr)}};
  }

  static Json part_json(const std::string& name, const ErrorParts& part, const ErrorParts& whole,
                        const std::optional<ReplicateMean>& similarity) {
    const double all = whole.raw * static_cast<double>(whole.pixels);
    return {{"name", name},
            {"pixels", part.pixels},
            {"ssim_display", similarity ? measured(*similarity) : Json(nullptr)},
            {"rmse_display", measured(part.rmse)},
            {"mean_square_display", measured(part.mean_square)},
            {"noise_display", std::sqrt(part.reference_noise)},
            {"prediction_noise_display", std::sqrt(part.prediction_noise)},
            {"share_of_squared_error",
             all > 0.0 ? Json(part.raw * static_cast<double>(part.pixels) / all) : Json(nullptr)}};
  }

  /// The error by parts of the picture that do not overlap; the first name that fits a pixel has it.
  static Json causes_json(const PredictionErrors& errors, const ErrorParts& whole, const std::vector<Region>& regions) {
    std::vector<Region> ordered;
    for (const char* name : {"lamp_rims", "specular", "occlusion_edges", "in_focus", "blurred"})
      for (const Region& region : regions)
        if (region.name == name) ordered.push_back(region);
    Json causes = Json::array();
    const double all = whole.error * static_cast<double>(whole.pixels);
    for (const Region& region : first_of(std::move(ordered))) {
      const ErrorParts part = errors.within(&region.mask);
      const auto pixels = static_cast<double>(part.pixels);
      causes.push_back(
          {{"name", region.name},
           {"pixels", part.pixels},
           {"share_of_squared_error", all > 0.0 ? Json(part.error * pixels / all) : Json(nullptr)},
           {"share_of_prediction_noise", all > 0.0 ? Json(part.prediction_noise * pixels / all) : Json(nullptr)},
           {"share_of_similarity_loss", errors.share_of_similarity_loss(region.mask)}});
    }
    return causes;
  }

  const AgreementCase& spec_;
  const Scene& scene_;
  std::uint64_t seed_;
  std::vector<Image> traced_linear_;
  std::optional<ReplicatePictures> traced_;
  MeasuredNoise fewer_, more_;
  ViewLayers layers_;
};

}  // namespace

Json agreement_entry(const AgreementCase& spec, const SceneDescription& description, std::uint64_t seed,
                     const std::filesystem::path& folder, const ProgressFunction& progress) {
  const Scene scene(description);
  Case view(spec, scene, seed);
  view.path_trace_all(progress);
  const std::string stem = "images/" + spec.id;
  write_picture(folder / (stem + "_path_traced"), view.mean(), exposure);
  Json predictions = Json::array();
  for (const PredictionSpec& prediction : spec.predictions) {
    const Pictures predicted = view.predict_all(prediction);
    const std::string file = stem + "_" + name_of(prediction.kind);
    write_picture(folder / file, predicted.linear.front(), exposure);
    Json entry = view.measured_against_traced(predicted);
    entry["kind"] = name_of(prediction.kind);
    entry["files"] = {{"predicted", file + ".exr"}, {"predicted_png", file + ".png"}};
    predictions.push_back(std::move(entry));
  }
  return {{"id", spec.id},
          {"note", spec.note},
          {"scene", spec.scene_name},
          {"gaze", spec.camera.gaze == Gaze::Foveal ? "foveal" : "camera"},
          {"spectacles", spec.worn.spectacles.has_value()},
          {"pupil_mm", 2e3 * spec.worn.eye.pupil_radius_m},
          {"resolution", {spec.camera.width, spec.camera.height}},
          {"files", {{"path_traced", stem + "_path_traced.exr"}, {"path_traced_png", stem + "_path_traced.png"}}},
          {"samples_per_pixel", spec.samples_per_pixel},
          {"replicates", spec.replicates},
          {"sharp_samples_per_pixel", spec.sharp_samples_per_pixel},
          {"seconds_path_traced", view.seconds_path_traced()},
          {"path_tracing", view.path_tracing()},
          {"noise_floor", view.noise_floor()},
          {"noise_floor_uncertainty", view.noise_floor_uncertainty()},
          {"predictions", std::move(predictions)}};
}

}  // namespace sturm
