#include <cmath>
#include <nlohmann/json.hpp>

#include "app/experiment/replicates.h"
#include "app/experiment/sections.h"
#include "app/image_files.h"
#include "app/json_values.h"
#include "app/stopwatch.h"
#include "compare/metrics/relative_mse.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "io/tone_map.h"

namespace sturm {

namespace {

constexpr double exposure = 1.0;                              // of the display space of metrics and PNG files
constexpr std::uint64_t sharp_view_stream = 0x5348415250ull;  // the prediction's noise is independent of the path tracer's

double ssim_display(const Image& a, const Image& b) {
  return ssim(to_display(a, exposure), to_display(b, exposure)).mean;
}
double ssim_linear(const Image& a, const Image& b) {
  return ssim(clamped(a), clamped(b)).mean;
}

/// A metric of the two mean images, and its standard error by the jackknife over the replicates (Efron & Stein 1981): each
/// replicate of both predictors is left out in turn.
template <class Metric>
Json with_jackknife_error(const Replicates& test, const Replicates& reference, const Metric& metric) {
  const int n = static_cast<int>(reference.images.size());
  std::vector<double> values;
  double mean = 0.0, squares = 0.0;
  for (int r = 0; r < n; ++r) {
    values.push_back(metric(test.mean(r), reference.mean(r)));
    mean += values.back() / n;
  }
  for (double v : values) squares += (v - mean) * (v - mean);
  return {{"value", metric(test.mean(), reference.mean())}, {"uncertainty", std::sqrt(squares * (n - 1.0) / n)}};
}

Json metrics_json(const Replicates& predicted, const Replicates& traced) {
  const Image p = predicted.mean(), t = traced.mean();
  return {{"ssim_display", with_jackknife_error(predicted, traced, ssim_display)},
          {"ssim_linear", with_jackknife_error(predicted, traced, ssim_linear)},
          {"psnr_display_dB", number_or_null(psnr_dB(to_display(p, exposure), to_display(t, exposure)))},
          {"rmse_linear", rmse(p, t)},
          {"relative_mse", relative_mse(p, t).plain}};
}

Json noise_floor_json(const Replicates& traced) {
  const Image a = traced.first_half(), b = traced.second_half();
  return {{"ssim_display", ssim_display(a, b)}, {"rmse_linear", rmse(a, b)}, {"relative_mse", relative_mse(a, b).plain}};
}

}  // namespace

Json image_entries(const ExperimentSpec& experiment, std::size_t index, const SceneDescription& description, SharedViews& views,
                   const std::filesystem::path& folder, const ProgressFunction& progress) {
  const ImageExperiment& spec = experiment.images[index];
  const std::uint64_t seed = experiment.seed;
  const Scene scene(description);
  const CameraPose pose = camera_pose(spec.camera);
  const double parts = static_cast<double>(spec.ray_models.size()) + 1.0;
  const auto part = [&](std::size_t k) {
    return [&progress, k, parts](double fraction) { progress((static_cast<double>(k) + fraction) / parts); };
  };

  RenderSettings sharp;
  sharp.samples_per_pixel = static_cast<int>(spec.sharp_samples_per_pixel);
  sharp.max_bounces = spec.max_bounces;
  const PredictedReplicates predicted =
      predict_replicates(scene, pose, spec.eye, sharp, seed ^ sharp_view_stream, spec.replicates, part(0));
  const std::string predicted_file = "images/" + spec.id + "_predicted";
  write_picture(folder / predicted_file, predicted.predictions.mean(), exposure);

  Json entries = Json::array();
  for (std::size_t k = 0; k < spec.ray_models.size(); ++k) {
    const RayModel model = *ray_model_named(spec.ray_models[k]);
    const std::shared_ptr<const SharedViews::View> view = views.get(index, model, [&] {
      RenderSettings settings;
      settings.samples_per_pixel = static_cast<int>(spec.samples_per_pixel);
      settings.max_bounces = spec.max_bounces;
      settings.guide_emitters = spec.guide_emitters;
      const Stopwatch watch;
      Replicates replicates = render_replicates(scene, pose, spec.eye, model, settings, seed, spec.replicates, part(k + 1));
      return SharedViews::View{std::move(replicates), watch.seconds(), spec.id + "/" + spec.ray_models[k]};
    });
    const Replicates& traced = view->replicates;
    const std::string traced_file = "images/" + spec.id + "_" + spec.ray_models[k];
    write_picture(folder / traced_file, traced.mean(), exposure);
    entries.push_back({{"id", spec.id},
                       {"scene", spec.scene_name},
                       {"prescription", spec.prescription},
                       {"pupil_mm", 2e3 * spec.eye.pupil_radius_m},
                       {"ray_model", spec.ray_models[k]},
                       {"files",
                        {{"path_traced", traced_file + ".exr"},
                         {"path_traced_png", traced_file + ".png"},
                         {"predicted", predicted_file + ".exr"},
                         {"predicted_png", predicted_file + ".png"}}},
                       {"seconds",
                        {{"path_traced", view->seconds},
                         {"sharp_view", predicted.times.sharp_view_seconds},
                         {"spreading", predicted.times.spreading_seconds},
                         {"predicted_total", predicted.times.sharp_view_seconds + predicted.times.spreading_seconds}}},
                       {"samples_per_pixel", spec.samples_per_pixel * static_cast<std::uint64_t>(spec.replicates)},
                       {"metrics", metrics_json(predicted.predictions, traced)},
                       {"noise_floor", noise_floor_json(traced)}});
    if (const std::string own = spec.id + "/" + spec.ray_models[k]; view->made_for != own) entries.back()["same_view_as"] = view->made_for;
  }
  return entries;
}

}  // namespace sturm
