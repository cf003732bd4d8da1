#include "app/comparison.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "app/compared_pictures.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double edge_frequencies[] = {0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5};
constexpr double psf_cell_px =
    4.0;  // cells of the total variation: several pixels, so that a shift by part of one counts little

const ImageMetricName& metric_named(const std::string& key) {
  const auto& names = image_metric_names();
  const auto found = std::find_if(names.begin(), names.end(), [&](const ImageMetricName& n) { return key == n.key; });
  if (found != names.end()) return *found;
  std::string known;
  for (const ImageMetricName& n : names) known += (known.empty() ? "" : ", ") + std::string(n.key);
  throw InputError("", "--bound", "\"" + key + "\"", "one of " + known);
}

void add_bound(const std::string& text, std::map<std::string, double>& bounds) {
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  metric_named(key);
  double value = 0.0;
  const char *first = text.data() + std::min(text.size(), equals == std::string::npos ? text.size() : equals + 1),
             *last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  if (first == last || error != std::errc() || end != last || !std::isfinite(value))
    throw InputError("", "--bound", "\"" + text + "\"", "METRIC=VALUE with a number");
  bounds[key] = value;
}

std::map<std::string, double> bounds_of(const CompareOptions& options) {
  std::map<std::string, double> bounds;
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) bounds[key] = *value;
  };
  add("ssim_display", options.min_ssim);
  add("psnr_display_dB", options.min_psnr_dB);
  add("rmse_linear", options.max_rmse);
  add("relative_mse", options.max_relative_mse);
  for (const std::string& text : options.bounds) add_bound(text, bounds);
  return bounds;
}

ImageMetricSettings settings_of(const CompareOptions& options, const PictureView& view, const Image& reference) {
  ImageMetricSettings settings;
  settings.exposure = options.exposure;
  if (options.pixels_per_degree)
    settings.pixels_per_degree = *options.pixels_per_degree;
  else if (view.pixels_per_degree)
    settings.pixels_per_degree = *view.pixels_per_degree;
  settings.hdr_exposures = hdr_flip_exposures(reference);
  if (!options.hdr_exposures.empty()) {
    const double start = options.hdr_exposures[0], stop = options.hdr_exposures[1], count = options.hdr_exposures[2];
    if (!(start <= stop && std::abs(start) <= 64.0 && std::abs(stop) <= 64.0 && count >= 1.0 && count <= 64.0 &&
          count == std::floor(count)))
      throw InputError("", "--hdr-exposures", "these numbers", "START ≤ STOP within ±64 and a whole COUNT of 1 … 64");
    settings.hdr_exposures = ExposureRange{start, stop, static_cast<int>(count)};
  }
  return settings;
}

void require_image_of_a_point(const Image& image, const std::string& path) {
  const double sum = std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0);
  if (!(sum > 0.0))
    throw InputError(path, "--psf", "pixels that sum to " + exact_number(sum), "the image of an emitter");
}

PsfComparison compare_as_psfs(const CompareOptions& options, const PictureView& view, const Image& test,
                              const Image& reference) {
  double pixel = 0.0;
  if (options.pixel_arcmin)
    pixel = *options.pixel_arcmin;
  else if (view.pixel_slope)
    pixel = *view.pixel_slope * arcminutes_per_radian;
  else
    throw InputError("", "--psf", "pictures that do not say how wide a pixel is", "--pixel-arcmin");
  require_image_of_a_point(test, options.test);
  require_image_of_a_point(reference, options.reference);
  return compare_psfs(spread_of_image(test, pixel), spread_of_image(reference, pixel), psf_cell_px * pixel);
}

}  // namespace

bool Comparison::keeps_bound(const std::string& key) const {
  const auto bound = bounds.find(key);
  if (bound == bounds.end()) return true;
  for (const ImageMetric& m : pictures.metrics) {
    if (m.key != key) continue;
    if (!m.value) return key.starts_with("psnr");
    return m.more_is_better ? *m.value >= bound->second : *m.value <= bound->second;
  }
  return false;
}

bool Comparison::passed() const {
  return std::all_of(bounds.begin(), bounds.end(), [&](const auto& bound) { return keeps_bound(bound.first); });
}

Comparison compare_files(const CompareOptions& options) {
  Comparison c;
  c.bounds = bounds_of(options);
  const ComparedPictures files = read_compared_pictures(options);
  const Image &test = files.test.image(), &reference = files.reference.image();
  const std::vector<Image>& seeds = files.seeds;
  const PictureView view = view_of(files.reference.picture, files.test.picture);
  c.test_file = {files.test.values, files.test.layer};
  c.reference_file = {files.reference.values, files.reference.layer};
  c.notes = files.notes;
  c.settings = settings_of(options, view, reference);
  std::vector<Region> regions;
  if (options.regions) {
    regions = regions_of(test, reference, options.exposure, view.layers);
    if (!view.missing_blur.empty()) c.regions_note = "in_focus and blurred cannot be told: " + view.missing_blur;
  }
  c.pictures = compare_pictures(test, reference, regions, c.settings, seeds.empty() ? nullptr : &seeds[0],
                                seeds.size() < 2 ? nullptr : &seeds[1]);
  if (!options.edge.empty()) {
    const PixelRectangle area{options.edge[0], options.edge[1], options.edge[2], options.edge[3]};
    c.edge = EdgeComparison{slanted_edge_mtf(test, area, edge_frequencies),
                            slanted_edge_mtf(reference, area, edge_frequencies)};
  }
  if (options.psf) c.psf = compare_as_psfs(options, view, test, reference);
  return c;
}

}  // namespace sturm
