#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/comparison.h"
#include "io/files/atomic_file.h"
#include "io/images/png_output.h"
#include "io/json/json_text.h"
#include "reports/markup/false_colour.h"

namespace sturm {

namespace {

constexpr double peak_quantile = 0.999;  // fireflies would leave the rest black

/// Errors of a map: similarities become what they lack.
Image errors_of(const ImageMetric& metric) {
  Image errors = metric.map;
  if (metric.map_is_similarity)
    for (float& v : errors.pixels) v = std::max(0.0f, 1.0f - v);
  return errors;
}

/// FLIP has a scale of its own; other errors get one that almost all pixels fit on.
double peak_of(const ImageMetric& metric, const Image& errors) {
  if (metric.key == "flip" || metric.key == "hdr_flip") return 1.0;
  std::vector<float> values = errors.pixels;
  const auto rank =
      values.begin() + static_cast<std::ptrdiff_t>(peak_quantile * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  const float largest = *std::max_element(rank, values.end());
  return *rank > 0.0f ? *rank : largest > 0.0f ? largest : 1.0;
}

}  // namespace

void write_maps(const Comparison& comparison, const std::string& folder) {
  const std::filesystem::path root(folder);
  std::filesystem::create_directories(root);
  Json scales = Json::object();
  for (const ImageMetric& metric : comparison.pictures.metrics) {
    if (metric.map.pixels.empty()) continue;
    const Image errors = errors_of(metric);
    const double peak = peak_of(metric, errors);
    const std::vector<unsigned char> png = encode_png(sequential_false_colour(errors, {peak, 0.0}));
    write_file_atomically(root / (metric.key + ".png"),
                          std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
    scales[metric.key] = {{"peak", peak},
                          {"shows", metric.map_is_similarity ? "1 - similarity" : "error of a pixel"},
                          {"margin_px", metric.margin}};
  }
  write_file_atomically(root / "scales.json", json_text(scales, 1) + "\n");
}

}  // namespace sturm
