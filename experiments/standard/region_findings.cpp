#include "experiments/standard/region_findings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/findings/prediction_reasons.h"
#include "compare/images/regions.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "compare/statistics/equal_error.h"
#include "compare/studies/agreement/agreement_measures.h"
#include "experiments/run/layer_sum.h"
#include "experiments/run/point_spread_mutations.h"
#include "experiments/run/replicates.h"
#include "experiments/standard/noise_floor.h"
#include "experiments/standard/stored_picture.h"
#include "io/images/tone_map.h"
#include "stages/plan/camera_pose.h"
#include "stages/prediction_stage.h"
#include "stages/stopwatch.h"
#include "stages/view_layers.h"

namespace sturm {

namespace {

constexpr std::uint64_t prediction_stream =
    0x41475245ull;                                     // the predictions' noise is independent of the path tracer's
constexpr std::uint64_t fewer_stream = 0x46455745ull;  // and so is that of its pictures of fewer samples
constexpr std::uint64_t fewer_divisor = 8;

/// Pictures of one view by one method, and the seconds of the fastest: other work on the machine only adds to a time.
struct Pictures {
  std::vector<Image> linear, display;
  std::map<std::string, double> seconds;
  std::vector<SurfacesPicture> surfaces;  ///< of point spreads over depth

  void add(Image image, std::map<std::string, double> parts) {
    display.push_back(to_display(image, metrics_exposure));
    linear.push_back(std::move(image));
    double total = 0.0;
    for (const auto& [part, s] : parts) total += s;
    parts["total"] = total;
    if (seconds.empty() || total < seconds.at("total")) seconds = std::move(parts);
  }
};

Estimate measured(const ReplicateMean& mean) {
  return {mean.value, mean.uncertainty};
}

/// None of nothing.
Number share(double part, double all) {
  return all > 0.0 ? Number(part / all) : std::nullopt;
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

/// One experiment at work.
class RegionStudy {
 public:
  RegionStudy(const PictureExperiment& spec, const Scene& scene, std::uint64_t seed)
      : spec_(spec), scene_(scene), seed_(seed) {}

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
      settings.seed = replicate_seed(seed_ ^ prediction_stream, r);
      if (prediction.kind == PredictionKind::Ellipses) {
        PredictedImage image =
            predict(scene_, camera_pose(spec_.camera), spec_.worn.eye, prediction.oversampling, settings);
        pictures.add(std::move(image.prediction.radiance),
                     {{"sharp_view", image.times.sharp_view_seconds}, {"spreading", image.times.spreading_seconds}});
      } else {
        PredictedView view = predict_view(scene_, spec_.camera, spec_.worn, 0.0, prediction, settings);
        pictures.add(std::move(view.layers.at("")), std::move(view.seconds));
        if (prediction.kind == PredictionKind::DepthPsf) pictures.surfaces.push_back(std::move(view.surfaces));
      }
    }
    return pictures;
  }

  PredictionFinding measured_against_traced(const Pictures& pictures) const {
    const ReplicatePictures predicted(pictures.display);
    const PredictionErrors errors(*traced_, predicted);
    const ErrorParts whole = errors.within(nullptr);
    const std::vector<Region> regions = regions_of_view(pictures.linear.front());
    PredictionFinding finding;
    finding.parts.push_back(part_errors("whole", whole, whole, errors.similarity()));
    for (const Region& region : regions)
      if (region.pixels() > 0)
        finding.parts.push_back(
            part_errors(region.name, errors.within(&region.mask), whole, errors.similarity(region.mask)));
    finding.causes = causes(errors, whole, regions);
    const SimilarityLoss loss = errors.similarity_loss();
    finding.similarity_loss = {loss.total, loss.reference_noise, loss.prediction_noise, loss.method};
    finding.squared_error = {
        .total = whole.error, .prediction_noise = whole.prediction_noise, .method = whole.method()};
    for (const auto& [part, seconds] : pictures.seconds) finding.seconds[part] = seconds;
    add_worth(whole, pictures.seconds.at("total"), finding);
    return finding;
  }

  /// What a prediction with an error would have brought about in place of the honest one, at the same time; none where
  /// the mutation is none of its kind.
  std::optional<PredictionFinding> mutated(const Mutation& mutation, const PredictionSpec& prediction,
                                           const Pictures& honest) const {
    if (prediction.kind != PredictionKind::DepthPsf || prediction.psf != SeenPsf::Rays) return std::nullopt;
    auto pictures = mutated_point_spreads(
        mutation, {spec_.worn.eye, pixel_slope(camera_pose(spec_.camera)), prediction, honest.surfaces, honest.linear});
    if (!pictures) return std::nullopt;
    Pictures wrong;
    for (Image& picture : *pictures) wrong.add(std::move(picture), honest.seconds);
    wrong.seconds = honest.seconds;
    return measured_against_traced(wrong);
  }

  /// What the layers of point spreads over depth give without composition.
  Pictures summed(const PredictionSpec& prediction, const Pictures& composited) const {
    std::map<std::string, double> parts = composited.seconds;
    for (const char* part : {"total", "kernels", "hidden_surfaces", "blur"}) parts.erase(part);
    Pictures sums;
    for (const SurfacesPicture& surfaces : composited.surfaces) {
      Stopwatch watch;
      Image sum = sum_of_layers(surfaces, spec_.worn.eye, pixel_slope(camera_pose(spec_.camera)), prediction);
      parts["layer_sum"] = watch.lap();
      sums.add(std::move(sum), parts);
    }
    return sums;
  }

  Image mean() const { return Replicates{traced_linear_}.mean(); }

  PathTracingCost cost() const {
    return {{fewer_.samples, more_.samples},
            {fewer_.seconds, more_.seconds},
            {std::sqrt(fewer_.variance), std::sqrt(more_.variance)},
            NoiseOverTime(fewer_, more_).order()};
  }
  double seconds_path_traced() const { return more_.seconds; }

  PictureNoiseFloor floor() const {
    static constexpr FloorMetric metrics[] = {
        {"ssim_display",
         [](const Image& a, const Image& b) {
           return ssim(to_display(a, metrics_exposure), to_display(b, metrics_exposure)).mean;
         }},
        {"rmse_display", [](const Image& a, const Image& b) {
           return rmse(to_display(a, metrics_exposure), to_display(b, metrics_exposure));
         }}};
    return noise_floor(Replicates{traced_linear_}, metrics);
  }

 private:
  Pictures path_traced(int samples, std::uint64_t seed, const ProgressFunction& progress) const {
    RenderSpec view;
    view.camera = spec_.camera;
    view.ray_model = spec_.ray_models.front();
    ViewPlan plan;
    plan.model = spec_.ray_models.front();
    plan.naked =
        spec_.camera.gaze == Gaze::Camera && !spec_.worn.spectacles && spec_.worn.eye.stiles_crawford_per_m2 == 0.0;
    RenderSettings settings;
    settings.samples_per_pixel = samples;
    settings.max_bounces = spec_.max_bounces;
    settings.guide_emitters = spec_.guide_emitters;
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

  std::vector<Region> regions_of_view(const Image& predicted) const {
    std::vector<Region> regions = regions_of(predicted, mean(), metrics_exposure, {layers_.depth, layers_.blur_px});
    regions.push_back({"specular", layers_.specular});
    regions.push_back({"lamp_rims", layers_.lamp_rims});
    for (float& v : regions.back().mask.pixels) v = v > 0.0f ? 1.0f : 0.0f;
    return regions;
  }

  /// What a prediction of this error and time is worth in path tracing.
  void add_worth(const ErrorParts& whole, double seconds, PredictionFinding& finding) const {
    const NoiseOverTime path_tracing(fewer_, more_);
    const double cost = seconds / path_tracing.seconds_per_sample();
    finding.samples_of_equal_error = path_tracing.samples_for(whole.error);
    if (const Number& samples = finding.samples_of_equal_error)
      finding.times_faster = path_tracing.seconds_for(*samples) / seconds;
    finding.cost_in_paths = cost;
    if (const auto needed = path_tracing.variance_of(speed_bar * cost)) finding.rmse_needed = std::sqrt(*needed);
  }

  static PartErrors part_errors(const std::string& name, const ErrorParts& part, const ErrorParts& whole,
                                const std::optional<ReplicateMean>& similarity) {
    PartErrors errors;
    errors.name = name;
    errors.pixels = part.pixels;
    if (similarity) errors.ssim = measured(*similarity);
    errors.rmse = measured(part.rmse);
    errors.mean_square = measured(part.mean_square);
    errors.reference_noise = std::sqrt(part.reference_noise);
    errors.prediction_noise = std::sqrt(part.prediction_noise);
    errors.share_of_squared_error =
        share(part.raw * static_cast<double>(part.pixels), whole.raw * static_cast<double>(whole.pixels));
    return errors;
  }

  /// The error by parts of the picture that do not overlap; the first name that fits a pixel has it.
  static std::vector<CauseShares> causes(const PredictionErrors& errors, const ErrorParts& whole,
                                         const std::vector<Region>& regions) {
    std::vector<Region> ordered;
    for (const char* name : {"lamp_rims", "specular", "occlusion_edges", "in_focus", "blurred"})
      for (const Region& region : regions)
        if (region.name == name) ordered.push_back(region);
    std::vector<CauseShares> causes;
    const double all = whole.error * static_cast<double>(whole.pixels);
    for (const Region& region : first_of(std::move(ordered))) {
      const ErrorParts part = errors.within(&region.mask);
      const auto pixels = static_cast<double>(part.pixels);
      causes.push_back({region.name, part.pixels, share(part.error * pixels, all),
                        share(part.prediction_noise * pixels, all), errors.share_of_similarity_loss(region.mask)});
    }
    return causes;
  }

  const PictureExperiment& spec_;
  const Scene& scene_;
  std::uint64_t seed_;
  std::vector<Image> traced_linear_;
  std::optional<ReplicatePictures> traced_;
  MeasuredNoise fewer_, more_;
  ViewLayers layers_;
};

/// What the experiment itself says.
PictureFinding stated(const PictureExperiment& spec) {
  PictureFinding finding;
  finding.measures = spec.measures;
  finding.id = spec.id;
  finding.note = spec.note;
  finding.scene = spec.scene_name;
  finding.ray_model = spec.ray_models.front();
  finding.gaze = spec.camera.gaze == Gaze::Foveal ? "foveal" : "camera";
  finding.spectacles = spec.worn.spectacles.has_value();
  finding.pupil_mm = 2e3 * spec.worn.eye.pupil_radius_m;
  finding.resolution = {static_cast<std::uint64_t>(spec.camera.width), static_cast<std::uint64_t>(spec.camera.height)};
  finding.replicates = static_cast<std::uint64_t>(spec.replicates);
  finding.samples_per_pixel = spec.samples_per_pixel * *finding.replicates;
  finding.sharp_samples_per_pixel = spec.sharp_samples_per_pixel;
  return finding;
}

}  // namespace

PictureFinding region_finding(const PictureExperiment& spec, const SceneDescription& description, std::uint64_t seed,
                              std::span<const Mutation> mutations, const std::filesystem::path& folder,
                              const ProgressFunction& progress) {
  const Scene scene(description);
  RegionStudy study(spec, scene, seed);
  study.path_trace_all(progress);
  PictureFinding finding = stated(spec);
  finding.path_traced = stored_picture(folder, spec.id + "_path_traced", study.mean());
  finding.seconds_path_traced = study.seconds_path_traced();
  finding.cost = study.cost();
  finding.noise_floor = study.floor();
  std::map<std::string, std::map<std::size_t, PredictionFinding>> mutated;  // of each mutation, by prediction
  for (const PredictionSpec& prediction : spec.predictions) {
    const Pictures predicted = study.predict_all(prediction);
    const auto finding_of = [&](const Pictures& pictures, bool layer_sum) {
      PredictionFinding found = study.measured_against_traced(pictures);
      found.kind = prediction.kind;
      found.psf = prediction.psf;
      found.layer_sum = layer_sum;
      found.files = stored_picture(folder, spec.id + "_" + found.kind_name(), pictures.linear.front());
      return found;
    };
    PredictionFinding found = finding_of(predicted, false);
    for (const Mutation& mutation : mutations)
      if (auto wrong = study.mutated(mutation, prediction, predicted)) {
        wrong->kind = found.kind;
        wrong->files = found.files;
        mutated[mutation.id].emplace(finding.predictions.size(), std::move(*wrong));
      }
    finding.predictions.push_back(std::move(found));
    if (spec.layer_sum && prediction.kind == PredictionKind::DepthPsf && prediction.psf == SeenPsf::Rays)
      finding.predictions.push_back(finding_of(study.summed(prediction, predicted), true));
  }
  const PictureFinding honest = finding;
  for (auto& [mutation, predictions] : mutated) {
    PictureFinding& wrong = finding.mutated.emplace(mutation, honest).first->second;
    for (auto& [index, prediction] : predictions) wrong.predictions[index] = std::move(prediction);
  }
  return finding;
}

}  // namespace sturm
