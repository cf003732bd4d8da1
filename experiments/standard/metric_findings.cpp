#include "experiments/standard/metric_findings.h"

#include "experiments/run/replicates.h"
#include "experiments/standard/picture_metrics.h"
#include "experiments/standard/stored_picture.h"
#include "stages/plan/camera_pose.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

constexpr std::uint64_t sharp_view_stream =
    0x5348415250ull;  // the prediction's noise is independent of the path tracer's

using View = std::shared_ptr<const SharedViews::View>;

RenderSettings settings_of(const PictureExperiment& spec, std::uint64_t samples_per_pixel) {
  RenderSettings settings;
  settings.samples_per_pixel = static_cast<int>(samples_per_pixel);
  settings.max_bounces = spec.max_bounces;
  return settings;
}

/// What mutations make of the findings of one experiment: predicted pictures of the mutated predictor against the
/// path-traced ones.
void add_mutated(std::vector<PictureFinding>& findings, const std::vector<View>& traced, const Eye& eye,
                 const PredictedReplicates& predicted, std::span<const Mutation> mutations) {
  const std::vector<PictureFinding> honest = findings;
  for (const Mutation& mutation : mutations) {
    if (const std::optional<Replicates> pictures = mutated_pictures(mutation, eye, predicted))
      for (std::size_t k = 0; k < honest.size(); ++k) {
        PictureFinding mutated = honest[k];
        mutated.predictions.front().metrics = picture_metrics(*pictures, traced[k]->replicates);
        findings[k].mutated[mutation.id] = std::move(mutated);
      }
    if (!std::holds_alternative<mutation::DroppedTangentialTerm>(mutation.kind)) continue;
    for (std::size_t k = 0; k < honest.size(); ++k)
      for (const PictureFinding& sin2 : honest) {
        if (honest[k].ray_model != RayModel::power_matrix || sin2.ray_model != RayModel::sin2_radial) continue;
        PictureFinding passed_off = sin2;
        passed_off.ray_model = RayModel::power_matrix;
        findings[k].mutated[mutation.id] = std::move(passed_off);
      }
  }
}

PredictionFinding prediction_of(const PredictedReplicates& predicted, const PictureFiles& files,
                                const Replicates& traced) {
  PredictionFinding prediction;
  prediction.kind = PredictionKind::Ellipses;
  prediction.files = files;
  const double sharp = predicted.times.sharp_view_seconds, spreading = predicted.times.spreading_seconds;
  prediction.seconds = {{"sharp_view", sharp}, {"spreading", spreading}, {"total", sharp + spreading}};
  prediction.metrics = picture_metrics(predicted.predictions, traced);
  return prediction;
}

PictureFinding finding_of(const PictureExperiment& spec, RayModel model) {
  PictureFinding finding;
  finding.measures = spec.measures;
  finding.id = spec.id;
  finding.scene = spec.scene_name;
  finding.prescription = spec.prescription;
  finding.pupil_mm = 2e3 * spec.worn.eye.pupil_radius_m;
  finding.ray_model = model;
  finding.replicates = static_cast<std::uint64_t>(spec.replicates);
  finding.samples_per_pixel = spec.samples_per_pixel * *finding.replicates;
  return finding;
}

}  // namespace

std::vector<PictureFinding> metric_findings(const ExperimentSpec& experiment, std::size_t index,
                                            const SceneDescription& description, SharedViews& views,
                                            std::span<const Mutation> mutations, const std::filesystem::path& folder,
                                            const ProgressFunction& progress) {
  const PictureExperiment& spec = experiment.pictures[index];
  const Eye& eye = spec.worn.eye;
  const std::uint64_t seed = experiment.seed;
  const Scene scene(description);
  const CameraPose pose = camera_pose(spec.camera);
  const double parts = static_cast<double>(spec.ray_models.size()) + 1.0;
  const auto part = [&](std::size_t k) {
    return [&progress, k, parts](double fraction) { progress((static_cast<double>(k) + fraction) / parts); };
  };

  const PredictedReplicates predicted =
      predict_replicates(scene, pose, eye, settings_of(spec, spec.sharp_samples_per_pixel), seed ^ sharp_view_stream,
                         spec.replicates, part(0));
  const PictureFiles predicted_files = stored_picture(folder, spec.id + "_predicted", predicted.predictions.mean());

  std::vector<PictureFinding> findings;
  std::vector<View> all_traced;
  for (std::size_t k = 0; k < spec.ray_models.size(); ++k) {
    const RayModel model = spec.ray_models[k];
    const std::string own = spec.id + "/" + name_of(model);
    const View view = views.get(index, model, [&] {
      RenderSettings settings = settings_of(spec, spec.samples_per_pixel);
      settings.guide_emitters = spec.guide_emitters;
      const Stopwatch watch;
      Replicates replicates = render_replicates(scene, pose, eye, model, settings, seed, spec.replicates, part(k + 1));
      return SharedViews::View{std::move(replicates), watch.seconds(), own};
    });
    all_traced.push_back(view);
    PictureFinding finding = finding_of(spec, model);
    finding.path_traced = stored_picture(folder, spec.id + "_" + name_of(model), view->replicates.mean());
    finding.seconds_path_traced = view->seconds;
    finding.noise_floor = noise_floor_of_metrics(view->replicates);
    finding.predictions = {prediction_of(predicted, predicted_files, view->replicates)};
    if (view->made_for != own) finding.same_view_as = view->made_for;
    findings.push_back(std::move(finding));
  }
  add_mutated(findings, all_traced, eye, predicted, mutations);
  return findings;
}

}  // namespace sturm
