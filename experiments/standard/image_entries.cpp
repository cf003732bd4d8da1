#include <nlohmann/json.hpp>

#include "experiments/run/replicates.h"
#include "experiments/run/sections.h"
#include "experiments/standard/image_metrics.h"
#include "stages/image_files.h"
#include "stages/plan/camera_pose.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

constexpr std::uint64_t sharp_view_stream =
    0x5348415250ull;  // the prediction's noise is independent of the path tracer's

/// What mutations make of the finished entries of one image, as patches (RFC 7396) of each entry: predicted pictures of
/// the mutated predictor against the path-traced ones.
void add_mutated(Json& entries, const std::vector<std::shared_ptr<const SharedViews::View>>& traced, const Eye& eye,
                 const PredictedReplicates& predicted, std::span<const Mutation> mutations) {
  for (const Mutation& mutation : mutations) {
    if (const std::optional<Replicates> pictures = mutated_pictures(mutation, eye, predicted))
      for (std::size_t k = 0; k < entries.size(); ++k)
        entries[k]["mutated"][mutation.id]["metrics"] = image_metrics_json(*pictures, traced[k]->replicates);
    if (!std::holds_alternative<mutation::DroppedTangentialTerm>(mutation.kind)) continue;
    for (Json& matrix : entries)
      for (const Json& sin2 : entries)
        if (matrix.at("ray_model") == "power_matrix" && sin2.at("ray_model") == "sin2_radial")
          matrix["mutated"][mutation.id] = {{"metrics", sin2.at("metrics")}, {"noise_floor", sin2.at("noise_floor")}};
  }
}

}  // namespace

Json image_entries(const ExperimentSpec& experiment, std::size_t index, const SceneDescription& description,
                   SharedViews& views, const std::filesystem::path& folder, const ProgressFunction& progress) {
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
  write_picture(folder / predicted_file, predicted.predictions.mean(), metrics_exposure);

  Json entries = Json::array();
  std::vector<std::shared_ptr<const SharedViews::View>> all_traced;
  for (std::size_t k = 0; k < spec.ray_models.size(); ++k) {
    const RayModel model = spec.ray_models[k];
    const std::string own = spec.id + "/" + name_of(model);
    const std::shared_ptr<const SharedViews::View> view = views.get(index, model, [&] {
      RenderSettings settings;
      settings.samples_per_pixel = static_cast<int>(spec.samples_per_pixel);
      settings.max_bounces = spec.max_bounces;
      settings.guide_emitters = spec.guide_emitters;
      const Stopwatch watch;
      Replicates replicates =
          render_replicates(scene, pose, spec.eye, model, settings, seed, spec.replicates, part(k + 1));
      return SharedViews::View{std::move(replicates), watch.seconds(), own};
    });
    all_traced.push_back(view);
    const Replicates& traced = view->replicates;
    const std::string traced_file = "images/" + spec.id + "_" + name_of(model);
    write_picture(folder / traced_file, traced.mean(), metrics_exposure);
    entries.push_back({{"id", spec.id},
                       {"scene", spec.scene_name},
                       {"prescription", spec.prescription},
                       {"pupil_mm", 2e3 * spec.eye.pupil_radius_m},
                       {"ray_model", name_of(model)},
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
                       {"metrics", image_metrics_json(predicted.predictions, traced)},
                       {"noise_floor", image_noise_floor_json(traced)},
                       {"noise_floor_uncertainty", image_noise_floor_uncertainty_json(traced)}});
    if (view->made_for != own) entries.back()["same_view_as"] = view->made_for;
  }
  add_mutated(entries, all_traced, spec.eye, predicted, mutations_named(experiment.mutations));
  return entries;
}

}  // namespace sturm
