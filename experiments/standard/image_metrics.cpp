#include "experiments/standard/image_metrics.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compare/images/part_jackknife.h"
#include "compare/metrics/displacement.h"
#include "compare/metrics/relative_mse.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "compare/statistics/jackknife.h"
#include "experiments/standard/noise_floor_error.h"
#include "io/images/tone_map.h"
#include "io/json/values.h"

namespace sturm {

namespace {

/// Mean pictures of both predictors, in linear light and in display space.
struct Pair {
  Image predicted, traced, predicted_shown, traced_shown;

  Pair(Image p, Image t)
      : predicted(std::move(p)),
        traced(std::move(t)),
        predicted_shown(to_display(predicted, metrics_exposure)),
        traced_shown(to_display(traced, metrics_exposure)) {}
};

/// One metric for all replicates (the first number) and with each replicate left out in turn.
class Jackknife {
 public:
  void add(std::optional<double> value) { values_.push_back(value); }

  Json json() const {
    std::vector<double> left_out;
    for (const std::optional<double>& v : values_) {
      if (!v) return {{"value", nullptr}, {"uncertainty", nullptr}};
      left_out.push_back(*v);
    }
    left_out.erase(left_out.begin());
    return {{"value", *values_[0]}, {"uncertainty", jackknife_standard_error(left_out)}};
  }

 private:
  std::vector<std::optional<double>> values_;
};

/// The mean of a similarity map, in the same order.
class SimilarityJackknife {
 public:
  void add(const Ssim& similarity) {
    if (shares_.empty()) mean_ = similarity.mean;
    shares_.push_back(shares_of_mean(similarity.map, least_part_px));
  }

  Json json() const {
    const PartError error = jackknife_by_parts(std::span(shares_).subspan(1));
    return {{"value", mean_}, {"uncertainty", error.standard_error}, {"degrees", error.degrees}};
  }

 private:
  static constexpr int least_part_px =
      48;  // four windows of SSIM and more: a tenth of the variance lies across the borders

  double mean_ = 0.0;
  std::vector<std::vector<double>> shares_;
};

double sum_of(const Image& image) {
  double sum = 0.0;
  for (const float v : image.pixels) sum += v;
  return sum;
}

std::optional<double> light_ratio(const Pair& pair) {
  const double traced = sum_of(pair.traced);
  return traced > 0.0 ? std::optional(sum_of(pair.predicted) / traced) : std::nullopt;
}

}  // namespace

Json image_metrics_json(const Replicates& predicted, const Replicates& traced) {
  const Pair whole(predicted.mean(), traced.mean());
  SimilarityJackknife ssim_display, ssim_linear;
  Jackknife light, shift_x, shift_y;
  const auto measure = [&](const Pair& pair) {
    ssim_display.add(ssim(pair.predicted_shown, pair.traced_shown));
    ssim_linear.add(ssim(clamped(pair.predicted), clamped(pair.traced)));
    light.add(light_ratio(pair));
    const std::optional<Eigen::Vector2d> shift = displacement_px(pair.predicted_shown, pair.traced_shown);
    shift_x.add(shift ? std::optional(shift->x()) : std::nullopt);
    shift_y.add(shift ? std::optional(shift->y()) : std::nullopt);
  };
  measure(whole);
  for (int r = 0; r < static_cast<int>(traced.images.size()); ++r) measure(Pair(predicted.mean(r), traced.mean(r)));
  return {{"ssim_display", ssim_display.json()},
          {"ssim_linear", ssim_linear.json()},
          {"light_ratio", light.json()},
          {"shift_x_px", shift_x.json()},
          {"shift_y_px", shift_y.json()},
          {"psnr_display_dB", number_or_null(psnr_dB(whole.predicted_shown, whole.traced_shown))},
          {"rmse_linear", rmse(whole.predicted, whole.traced)},
          {"relative_mse", relative_mse(whole.predicted, whole.traced).plain}};
}

namespace {

using Measure = double (*)(const Image&, const Image&);

/// What a noise floor has, by the metric's key.
constexpr std::pair<const char*, Measure> noise_floor_measures[] = {
    {"ssim_display",
     [](const Image& a, const Image& b) {
       return ssim(to_display(a, metrics_exposure), to_display(b, metrics_exposure)).mean;
     }},
    {"rmse_linear", [](const Image& a, const Image& b) { return rmse(a, b); }},
    {"relative_mse", [](const Image& a, const Image& b) { return relative_mse(a, b).plain; }}};

}  // namespace

Json image_noise_floor_json(const Replicates& traced) {
  const Image a = traced.first_half(), b = traced.second_half();
  Json result;
  for (const auto& [key, measure] : noise_floor_measures) result[key] = measure(a, b);
  return result;
}

Json image_noise_floor_uncertainty_json(const Replicates& traced) {
  Json result;
  for (const auto& [key, measure] : noise_floor_measures)
    if (const auto error = noise_floor_error(traced, measure)) result[key] = *error;
  return result;
}

}  // namespace sturm
