#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/experiment/replicates.h"
#include "app/experiment/sections.h"
#include "app/image_files.h"
#include "app/json_values.h"
#include "app/prediction_stage.h"
#include "app/stopwatch.h"
#include "app/view_layers.h"
#include "compare/image_comparison.h"
#include "compare/jackknife.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "compare/regions.h"
#include "io/tone_map.h"

namespace sturm {

namespace {

constexpr double exposure = 1.0;
constexpr std::uint64_t sharp_view_stream = 0x41475245ull;  // the predictions' noise is independent of the path tracer's

/// Pictures of one view by one method in display space, and the seconds that one of them took on average.
struct Pictures {
  std::vector<Image> linear, display;
  std::map<std::string, double> seconds;

  void add(Image image) {
    display.push_back(to_display(image, exposure));
    linear.push_back(std::move(image));
  }
};

Image mean_of(const std::vector<Image>& images) {
  return Replicates{images}.mean();
}

/// Mean of squared differences over the channels of the pixels of a mask; null for all.
double mean_square(const Image& a, const Image& b, const Image* mask) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (mask && !(mask->pixels[i / static_cast<std::size_t>(a.channels)] > 0.0f)) continue;
    const double d = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    sum += d * d;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// Variance of a single path-traced picture about the expectation, in display space: the scatter of R of them about their mean, R/(R − 1).
double single_variance(const Pictures& traced, const Image& mean, const Image* mask) {
  double sum = 0.0;
  for (const Image& image : traced.display) sum += mean_square(image, mean, mask);
  return sum / (static_cast<double>(traced.display.size()) - 1.0);
}

/// What a part of the picture says of a prediction, in display space.
struct Scores {
  std::optional<double> ssim;
  double rmse = 0.0;         ///< mean over the predicted pictures; the reference's noise is taken off each squared error, down to zero
  double mean_square = 0.0;  ///< the same before the root, unbiased: may be negative
};

/// A score with its jackknife error; null where one of the samples has none.
template <class Of>
Json measured(const std::vector<Scores>& samples, const Of& of) {
  std::vector<double> left_out;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::optional<double> value = of(samples[k]);
    if (!value) return nullptr;
    if (k > 0) left_out.push_back(*value);
  }
  return {{"value", *of(samples[0])}, {"uncertainty", jackknife_standard_error(left_out)}};
}

std::optional<double> mean_within(const Image& map, int margin, const Image* mask) {
  if (!mask) {
    double sum = 0.0;
    for (const float v : map.pixels) sum += v;
    return sum / static_cast<double>(map.pixels.size());
  }
  const std::vector<double> values = values_within(map, margin, *mask);
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

class Case {
 public:
  Case(const AgreementCase& spec, const Scene& scene, std::uint64_t seed) : spec_(spec), scene_(scene), seed_(seed) {}

  void path_trace_all(const ProgressFunction& progress) {
    RenderSpec view;
    view.camera = spec_.camera;
    view.ray_model = "power_matrix";
    ViewPlan plan;
    plan.naked = spec_.camera.gaze == Gaze::Camera && !spec_.worn.spectacles && spec_.worn.eye.stiles_crawford_per_m2 == 0.0;
    RenderSettings settings;
    settings.samples_per_pixel = static_cast<int>(spec_.samples_per_pixel);
    settings.max_bounces = spec_.max_bounces;
    settings.guide_emitters = true;
    for (int r = 0; r < spec_.replicates; ++r) {
      settings.seed = replicate_seed(seed_, r);
      settings.progress = [&](double fraction) { progress((r + fraction) / spec_.replicates); };
      Stopwatch watch;
      traced_.add(path_trace_view(scene_, view, spec_.worn, 0.0, settings, plan).radiance);
      traced_.seconds["total"] += watch.lap() / spec_.replicates;
    }
    mean_ = mean_of(traced_.linear);
    mean_display_ = mean_of(traced_.display);
    const Replicates display{traced_.display};
    for (int k = 0; k < spec_.replicates; ++k) means_without_.push_back(display.mean(k));
    layers_ = view_layers(scene_, sight_field(spec_.camera, spec_.worn, 0.0));
  }

  Pictures predict_all(const PredictionSpec& prediction) const {
    Pictures pictures;
    RenderSettings settings;
    settings.samples_per_pixel = static_cast<int>(spec_.sharp_samples_per_pixel);
    settings.max_bounces = spec_.max_bounces;
    for (int r = 0; r < spec_.replicates; ++r) {
      settings.seed = replicate_seed(seed_ ^ sharp_view_stream, r);
      std::map<std::string, double> seconds;
      if (prediction.kind == PredictionKind::Ellipses) {
        PredictedImage image = predict(scene_, camera_pose(spec_.camera), spec_.worn.eye, prediction.oversampling, settings);
        seconds = {{"sharp_view", image.times.sharp_view_seconds}, {"spreading", image.times.spreading_seconds}};
        pictures.add(std::move(image.prediction.radiance));
      } else {
        PredictedView view = predict_view(scene_, spec_.camera, spec_.worn, 0.0, prediction, settings);
        seconds = view.seconds;
        pictures.add(std::move(view.layers.at("")));
      }
      for (const auto& [part, s] : seconds) {
        pictures.seconds[part] += s / spec_.replicates;
        pictures.seconds["total"] += s / spec_.replicates;
      }
    }
    return pictures;
  }

  Json measured_against_traced(const Pictures& predicted) const {
    RegionLayers told_by{layers_.depth, layers_.blur_px};
    std::vector<Region> regions = regions_of(predicted.linear.front(), mean_, exposure, told_by);
    regions.push_back({"specular", layers_.specular});
    const std::vector<Sample> samples = samples_of(predicted);
    Json parts = Json::array({part_json("whole", samples, nullptr)});
    for (const Region& region : regions)
      if (region.pixels() > 0) parts.push_back(part_json(region.name, samples, &region.mask));
    const double n = static_cast<double>(spec_.samples_per_pixel), one = single_variance(traced_, mean_display_, nullptr);
    const double error = scores_of(samples[0], one, nullptr).mean_square;
    const bool known = error > 0.0;
    const double samples_per_pixel = known ? n * one / error : 0.0, seconds = traced_.seconds.at("total") * samples_per_pixel / n;
    return {{"seconds", predicted.seconds},
            {"samples_of_equal_error", known ? Json(samples_per_pixel) : Json(nullptr)},
            {"times_faster", known ? Json(seconds / predicted.seconds.at("total")) : Json(nullptr)},
            {"parts", parts}};
  }

  const Pictures& traced() const { return traced_; }
  const Image& mean() const { return mean_; }

  /// SSIM and error of two halves of the replicates: what noise alone makes of a comparison with half of the samples each.
  Json noise_floor() const {
    const Replicates all{traced_.linear};
    const Image a = to_display(all.first_half(), exposure), b = to_display(all.second_half(), exposure);
    return {{"ssim_display", ssim(a, b).mean}, {"rmse_display", rmse(a, b)}};
  }

 private:
  /// Predicted pictures against the mean of path-traced ones.
  struct Sample {
    std::vector<const Image*> predicted;
    const Image* reference;
    double reference_variance;       ///< over that of a single path-traced picture
    std::vector<Ssim> similarities;  ///< of each predicted picture
  };

  Sample sample(std::vector<const Image*> predicted, const Image& reference, double reference_variance) const {
    Sample s{std::move(predicted), &reference, reference_variance, {}};
    for (const Image* image : s.predicted) s.similarities.push_back(ssim(*image, reference));
    return s;
  }

  /// All replicates of both, then with number 0, 1, … of both left out: what an uncertainty needs that counts the noise of both.
  std::vector<Sample> samples_of(const Pictures& predicted) const {
    std::vector<const Image*> all;
    for (const Image& image : predicted.display) all.push_back(&image);
    const double r = spec_.replicates;
    std::vector<Sample> samples{sample(all, mean_display_, 1.0 / r)};
    for (std::size_t k = 0; k < all.size(); ++k) {
      std::vector<const Image*> others = all;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      samples.push_back(sample(std::move(others), means_without_[k], 1.0 / (r - 1.0)));
    }
    return samples;
  }

  /// `one`: variance of a single path-traced picture within the mask.
  static Scores scores_of(const Sample& s, double one, const Image* mask) {
    Scores scores;
    const double n = static_cast<double>(s.predicted.size()), noise = one * s.reference_variance;
    double similarity = 0.0;
    bool similarity_known = true;
    for (std::size_t i = 0; i < s.predicted.size(); ++i) {
      const Image &image = *s.predicted[i], &map = s.similarities[i].map;
      const std::optional<double> mean = mean_within(map, (image.width - map.width) / 2, mask);
      similarity_known = similarity_known && mean.has_value();
      similarity += mean.value_or(0.0) / n;
      const double square = mean_square(image, *s.reference, mask) - noise;
      scores.mean_square += square / n;
      scores.rmse += std::sqrt(std::max(0.0, square)) / n;
    }
    if (similarity_known) scores.ssim = similarity;
    return scores;
  }

  Json part_json(const std::string& name, const std::vector<Sample>& samples, const Image* mask) const {
    const double one = single_variance(traced_, mean_display_, mask), r = spec_.replicates;
    std::vector<Scores> scores;
    for (const Sample& s : samples) scores.push_back(scores_of(s, one, mask));
    double whole = 0.0, inside = 0.0;
    for (const Image* image : samples[0].predicted) {
      whole += mean_square(*image, mean_display_, nullptr) * static_cast<double>(count(nullptr));
      inside += mean_square(*image, mean_display_, mask) * static_cast<double>(count(mask));
    }
    return {{"name", name},
            {"pixels", count(mask)},
            {"ssim_display", measured(scores, [](const Scores& s) { return s.ssim; })},
            {"rmse_display", measured(scores, [](const Scores& s) { return std::optional(s.rmse); })},
            {"mean_square_display", measured(scores, [](const Scores& s) { return std::optional(s.mean_square); })},
            {"noise_display", std::sqrt(one / r)},
            {"share_of_squared_error", whole > 0.0 ? Json(inside / whole) : Json(nullptr)}};
  }

  std::size_t count(const Image* mask) const {
    if (!mask) return static_cast<std::size_t>(mean_.width) * static_cast<std::size_t>(mean_.height);
    return static_cast<std::size_t>(std::count_if(mask->pixels.begin(), mask->pixels.end(), [](float v) { return v > 0.0f; }));
  }

  const AgreementCase& spec_;
  const Scene& scene_;
  std::uint64_t seed_;
  Pictures traced_;
  Image mean_, mean_display_;
  std::vector<Image> means_without_;  ///< in display space: the mean of all path-traced pictures but number k
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
          {"seconds_path_traced", view.traced().seconds.at("total")},
          {"noise_floor", view.noise_floor()},
          {"predictions", std::move(predictions)}};
}

}  // namespace sturm
