#include "compare/images/image_comparison.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

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

/// The same two pictures in one space: as they are, and clamped to [0, 1], as a peak of 1 demands.
struct Pair {
  Image test, reference;
  Image clamped_test, clamped_reference;

  Pair(Image t, Image r)
      : test(std::move(t)),
        reference(std::move(r)),
        clamped_test(clamped(test)),
        clamped_reference(clamped(reference)) {}
};

/// What metrics are made of.
struct Compared {
  Pair display, linear;
  const ImageMetricSettings& settings;
};

/// A metric that `summary` makes of the local values of its map.
ImageMetric of_map(double value, Image map, double (*summary)(const std::vector<double>&), int margin = 0) {
  ImageMetric m;
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

/// A metric of one error for each pixel.
ImageMetric of_errors(const Pair& pair, double value, const std::vector<double>& errors,
                      double (*summary)(const std::vector<double>&)) {
  return of_map(value, error_map(errors, pair.test.width, pair.test.height), summary);
}

ImageMetric of_ssim(const Pair& pair) {
  Ssim similarity = ssim(pair.clamped_test, pair.clamped_reference);
  ImageMetric m = of_map(similarity.mean, std::move(similarity.map), mean_of, SimilarityMaps::margin);
  m.map_is_similarity = true;
  m.window_px = 2 * SimilarityMaps::margin + 1;
  return m;
}

ImageMetric of_ms_ssim(const Pair& pair) {
  ImageMetric m;
  m.within = [](const Image&) { return std::nullopt; };
  if (std::optional<MsSsim> measured = ms_ssim(pair.clamped_test, pair.clamped_reference)) {
    m.value = measured->value;
    m.map = measured->local_map(pair.test.width, pair.test.height);
    m.map_is_similarity = true;
    m.window_px = MsSsim::window_px;
    m.within = [shared = std::make_shared<const MsSsim>(std::move(*measured))](const Image& mask) {
      return shared->within(mask);
    };
  }
  return m;
}

ImageMetric of_psnr(const Pair& pair) {
  const Image &a = pair.clamped_test, &b = pair.clamped_reference;
  return of_errors(pair, psnr_dB(a, b), squared_errors(a, b), decibels);
}

ImageMetric of_rmse(const Pair& pair) {
  return of_errors(pair, rmse(pair.test, pair.reference), squared_errors(pair.test, pair.reference), root_of_mean);
}

ImageMetric of_relative_mse(const Pair& pair) {
  const std::vector<double> errors = relative_squared_errors(pair.test, pair.reference);
  return of_errors(pair, mean_of(errors), errors, mean_of);
}

ImageMetric of_trimmed_relative_mse(const Pair& pair) {
  const std::vector<double> errors = relative_squared_errors(pair.test, pair.reference);
  ImageMetric m = of_errors(pair, trimmed(errors), errors, trimmed);
  m.map = {};  // that of the plain mean
  return m;
}

ImageMetric of_smape(const Pair& pair) {
  const std::vector<double> errors = symmetric_relative_errors(pair.test, pair.reference);
  return of_errors(pair, mean_of(errors), errors, mean_of);
}

ImageMetric of_flip(Flip flip, double pixels_per_degree) {
  ImageMetric m = of_map(flip.mean, std::move(flip.map), mean_of);
  m.window_px = flip_window_px(pixels_per_degree);
  return m;
}

ImageMetric of_shown_flip(const Compared& c) {
  const double pixels_per_degree = c.settings.pixels_per_degree;
  return of_flip(flip(c.display.test, c.display.reference, pixels_per_degree), pixels_per_degree);
}

ImageMetric of_hdr_flip(const Compared& c) {
  const double pixels_per_degree = c.settings.pixels_per_degree;
  const ExposureRange exposures = c.settings.hdr_exposures.value_or(hdr_flip_exposures(c.linear.reference));
  return of_flip(hdr_flip(c.linear.test, c.linear.reference, pixels_per_degree, exposures), pixels_per_degree);
}

ImageMetric of_ciede2000(const Compared& c) {
  Ciede2000 colour = ciede2000(c.display.test, c.display.reference);
  return of_map(colour.mean, std::move(colour.map), mean_of);
}

template <ImageMetric (*make)(const Pair&)>
ImageMetric display(const Compared& c) {
  return make(c.display);
}

template <ImageMetric (*make)(const Pair&)>
ImageMetric linear(const Compared& c) {
  return make(c.linear);
}

struct MetricKind {
  ImageMetricName name;
  ImageMetric (*make)(const Compared& compared);  ///< all but its name
};

/// All metrics, in the order of the tables. Relative errors are about linear light unless their key says otherwise.
constexpr MetricKind metric_kinds[] = {
    {{"ssim_display", "SSIM, display space", true}, display<of_ssim>},
    {{"ms_ssim_display", "MS-SSIM, display space", true}, display<of_ms_ssim>},
    {{"psnr_display_dB", "PSNR, display space [dB]", true}, display<of_psnr>},
    {{"rmse_display", "RMSE, display space", false}, display<of_rmse>},
    {{"relative_mse_display", "relative MSE, display space", false}, display<of_relative_mse>},
    {{"relative_mse_display_trimmed", "the same without the worst 0.1 %", false}, display<of_trimmed_relative_mse>},
    {{"smape_display", "SMAPE, display space", false}, display<of_smape>},
    {{"flip", "FLIP", false}, of_shown_flip},
    {{"ciede2000", "CIEDE2000", false}, of_ciede2000},
    {{"ssim_linear", "SSIM, linear clamped to 0 … 1", true}, linear<of_ssim>},
    {{"ms_ssim_linear", "MS-SSIM, linear clamped to 0 … 1", true}, linear<of_ms_ssim>},
    {{"psnr_linear_dB", "PSNR, linear clamped to 0 … 1 [dB]", true}, linear<of_psnr>},
    {{"rmse_linear", "RMSE, linear", false}, linear<of_rmse>},
    {{"relative_mse", "relative MSE, linear", false}, linear<of_relative_mse>},
    {{"relative_mse_trimmed", "relative MSE without the worst 0.1 %", false}, linear<of_trimmed_relative_mse>},
    {{"smape", "SMAPE, linear", false}, linear<of_smape>},
    {{"hdr_flip", "HDR-FLIP", false}, of_hdr_flip},
};

}  // namespace

const std::vector<ImageMetricName>& image_metric_names() {
  static const std::vector<ImageMetricName> names = [] {
    std::vector<ImageMetricName> all;
    for (const MetricKind& kind : metric_kinds) all.push_back(kind.name);
    return all;
  }();
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
  const Compared compared{
      {to_display(test, settings.exposure), to_display(reference, settings.exposure)}, {test, reference}, settings};
  std::vector<ImageMetric> metrics;
  for (const MetricKind& kind : metric_kinds) {
    metrics.push_back(kind.make(compared));
    metrics.back().key = kind.name.key;
    metrics.back().title = kind.name.title;
    metrics.back().more_is_better = kind.name.more_is_better;
  }
  return metrics;
}

}  // namespace sturm
