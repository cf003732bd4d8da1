#include "experiments/standard/picture_metrics.h"

#include <cmath>
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
#include "experiments/standard/noise_floor.h"
#include "experiments/standard/stored_picture.h"
#include "io/images/tone_map.h"

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

  PictureMetric metric() const {
    std::vector<double> left_out;
    for (const std::optional<double>& v : values_) {
      if (!v) return {.value = std::nullopt, .has_error = true};
      left_out.push_back(*v);
    }
    left_out.erase(left_out.begin());
    return {.value = values_[0], .has_error = true, .uncertainty = jackknife_standard_error(left_out)};
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

  PictureMetric metric() const {
    const PartError error = jackknife_by_parts(std::span(shares_).subspan(1));
    return {.value = mean_, .has_error = true, .uncertainty = error.standard_error, .degrees = error.degrees};
  }

 private:
  static constexpr int least_part_px =
      48;  // four windows of SSIM and more: a tenth of the variance lies across the borders

  double mean_ = 0.0;
  std::vector<std::vector<double>> shares_;
};

/// The PSNR of equal pictures is infinite: none.
PictureMetric without_error(double value) {
  return {.value = std::isfinite(value) ? std::optional(value) : std::nullopt};
}

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

std::map<std::string, PictureMetric> picture_metrics(const Replicates& predicted, const Replicates& traced) {
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
  return {{"ssim_display", ssim_display.metric()},
          {"ssim_linear", ssim_linear.metric()},
          {"light_ratio", light.metric()},
          {"shift_x_px", shift_x.metric()},
          {"shift_y_px", shift_y.metric()},
          {"psnr_display_dB", without_error(psnr_dB(whole.predicted_shown, whole.traced_shown))},
          {"rmse_linear", without_error(rmse(whole.predicted, whole.traced))},
          {"relative_mse", without_error(relative_mse(whole.predicted, whole.traced).plain)}};
}

PictureNoiseFloor noise_floor_of_metrics(const Replicates& traced) {
  static constexpr FloorMetric metrics[] = {
      {"ssim_display",
       [](const Image& a, const Image& b) {
         return ssim(to_display(a, metrics_exposure), to_display(b, metrics_exposure)).mean;
       }},
      {"rmse_linear", [](const Image& a, const Image& b) { return rmse(a, b); }},
      {"relative_mse", [](const Image& a, const Image& b) { return relative_mse(a, b).plain; }}};
  return noise_floor(traced, metrics);
}

}  // namespace sturm
