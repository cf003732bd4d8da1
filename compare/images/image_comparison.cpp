#include "compare/images/image_comparison.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "compare/metrics/ciede2000.h"
#include "compare/metrics/comparable.h"
#include "compare/metrics/ms_ssim.h"
#include "compare/metrics/pixel_errors.h"
#include "compare/metrics/relative_mse.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/similarity_maps.h"
#include "compare/metrics/ssim.h"
#include "io/images/tone_map.h"

namespace sturm {

namespace {

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double root_of_mean(const std::vector<double>& squares) {
  return std::sqrt(mean_of(squares));
}

/// PSNR for a peak of 1 from squared errors.
double decibels(const std::vector<double>& squares) {
  return -10.0 * std::log10(mean_of(squares));
}

double trimmed(const std::vector<double>& errors) {
  return trimmed_mean(errors);
}

/// A metric that `summary` makes of the local values of its map.
ImageMetric of_map(std::string key, double value, Image map, double (*summary)(const std::vector<double>&),
                   int margin = 0) {
  ImageMetric m;
  m.key = std::move(key);
  m.value = finite(value);
  m.margin = margin;
  const auto shared = std::make_shared<const Image>(map);
  m.map = std::move(map);
  m.within = [shared, summary, margin](const Image& mask) -> std::optional<double> {
    const std::vector<double> inside = values_within(*shared, margin, mask);
    return inside.empty() ? std::nullopt : finite(summary(inside));
  };
  return m;
}

ImageMetric of_ms_ssim(std::string key, const Image& test, const Image& reference) {
  ImageMetric m;
  m.key = std::move(key);
  m.within = [](const Image&) { return std::nullopt; };
  if (std::optional<MsSsim> measured = ms_ssim(test, reference)) {
    m.value = measured->value;
    m.map = measured->local_map(test.width, test.height);
    m.map_is_similarity = true;
    m.window_px = MsSsim::window_px;
    m.within = [shared = std::make_shared<const MsSsim>(std::move(*measured))](const Image& mask) {
      return shared->within(mask);
    };
  }
  return m;
}

/// The metrics that exist in both spaces; `space` is "display" or "linear". `test`, `reference`: as they are; the first
/// four metrics of linear light see it clamped to [0, 1], as a peak of 1 demands.
void add_common(std::vector<ImageMetric>& metrics, const std::string& space, const Image& test,
                const Image& reference) {
  const int width = test.width, height = test.height;
  const Image a = clamped(test), b = clamped(reference);
  Ssim similarity = ssim(a, b);
  metrics.push_back(
      of_map("ssim_" + space, similarity.mean, std::move(similarity.map), mean_of, SimilarityMaps::margin));
  metrics.back().map_is_similarity = true;
  metrics.back().window_px = 2 * SimilarityMaps::margin + 1;
  metrics.push_back(of_ms_ssim("ms_ssim_" + space, a, b));
  metrics.push_back(
      of_map("psnr_" + space + "_dB", psnr_dB(a, b), error_map(squared_errors(a, b), width, height), decibels));
  metrics.push_back(of_map("rmse_" + space, rmse(test, reference),
                           error_map(squared_errors(test, reference), width, height), root_of_mean));
  const std::vector<double> relative = relative_squared_errors(test, reference),
                            symmetric = symmetric_relative_errors(test, reference);
  const std::string suffix =
      space == "linear" ? "" : "_" + space;  // relative errors are about linear light unless said otherwise
  metrics.push_back(of_map("relative_mse" + suffix, mean_of(relative), error_map(relative, width, height), mean_of));
  metrics.push_back(
      of_map("relative_mse" + suffix + "_trimmed", trimmed(relative), error_map(relative, width, height), trimmed));
  metrics.back().map = {};  // that of the plain mean
  metrics.push_back(of_map("smape" + suffix, mean_of(symmetric), error_map(symmetric, width, height), mean_of));
}

}  // namespace

const std::vector<ImageMetricName>& image_metric_names() {
  static const std::vector<ImageMetricName> names{
      {"ssim_display", "SSIM, display space", true},
      {"ms_ssim_display", "MS-SSIM, display space", true},
      {"psnr_display_dB", "PSNR, display space [dB]", true},
      {"rmse_display", "RMSE, display space", false},
      {"relative_mse_display", "relative MSE, display space", false},
      {"relative_mse_display_trimmed", "the same without the worst 0.1 %", false},
      {"smape_display", "SMAPE, display space", false},
      {"flip", "FLIP", false},
      {"ciede2000", "CIEDE2000", false},
      {"ssim_linear", "SSIM, linear clamped to 0 … 1", true},
      {"ms_ssim_linear", "MS-SSIM, linear clamped to 0 … 1", true},
      {"psnr_linear_dB", "PSNR, linear clamped to 0 … 1 [dB]", true},
      {"rmse_linear", "RMSE, linear", false},
      {"relative_mse", "relative MSE, linear", false},
      {"relative_mse_trimmed", "relative MSE without the worst 0.1 %", false},
      {"smape", "SMAPE, linear", false},
      {"hdr_flip", "HDR-FLIP", false},
  };
  return names;
}

std::vector<double> values_within(const Image& map, int margin, const Image& mask) {
  std::vector<double> values;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (*mask.at(x + margin, y + margin) > 0.0f) values.push_back(*map.at(x, y));
  return values;
}

std::vector<ImageMetric> measure_images(const Image& test, const Image& reference,
                                        const ImageMetricSettings& settings) {
  require_colour_pair(test, reference);
  const Image shown = to_display(test, settings.exposure), shown_reference = to_display(reference, settings.exposure);
  std::vector<ImageMetric> metrics;
  add_common(metrics, "display", shown, shown_reference);
  Flip seen = flip(shown, shown_reference, settings.pixels_per_degree);
  metrics.push_back(of_map("flip", seen.mean, std::move(seen.map), mean_of));
  metrics.back().window_px = flip_window_px(settings.pixels_per_degree);
  Ciede2000 colour = ciede2000(shown, shown_reference);
  metrics.push_back(of_map("ciede2000", colour.mean, std::move(colour.map), mean_of));
  add_common(metrics, "linear", test, reference);
  const ExposureRange exposures = settings.hdr_exposures.value_or(hdr_flip_exposures(reference));
  Flip hdr = hdr_flip(test, reference, settings.pixels_per_degree, exposures);
  metrics.push_back(of_map("hdr_flip", hdr.mean, std::move(hdr.map), mean_of));
  metrics.back().window_px = flip_window_px(settings.pixels_per_degree);
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const ImageMetricName& name = image_metric_names()[i];
    if (metrics[i].key != name.key) throw std::logic_error("metric " + metrics[i].key + " out of order");
    metrics[i].title = name.title;
    metrics[i].more_is_better = name.more_is_better;
  }
  return metrics;
}

}  // namespace sturm
