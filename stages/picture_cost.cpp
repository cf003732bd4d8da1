#include "stages/picture_cost.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/files/formatted_text.h"
#include "io/specs/sharp_view_samples.h"

namespace sturm {

namespace {

/// Path-traced samples with the SSIM of a prediction whose sharp view has samples_of_sharp_view, in the shipped views
/// (docs/commands/render.md#what-a-prediction-buys).
struct EqualPaths {
  PredictionKind kind;
  const char* samples;
};
constexpr EqualPaths measured[] = {{PredictionKind::Ellipses, "about 16"},
                                   {PredictionKind::Layered, "at least 64"},
                                   {PredictionKind::Multipass, "at least 64"},
                                   {PredictionKind::DepthPsf, "at least 60"}};

/// "4.9 s (sharp view 4.1, passes 0.3)": parts of less than a hundredth of the whole are left out.
std::string seconds_text(const RenderOutput& picture) {
  double total = 0.0;
  for (const auto& [part, seconds] : picture.seconds) total += seconds;
  std::vector<std::pair<double, std::string>> parts;
  for (const auto& [part, seconds] : picture.seconds)
    if (seconds >= 0.01 * total) parts.emplace_back(seconds, part);
  std::sort(parts.rbegin(), parts.rend());
  std::string listed;
  for (auto& [seconds, part] : parts) {
    std::replace(part.begin(), part.end(), '_', ' ');
    listed += (listed.empty() ? " (" : ", ") + part + " " + plain_number(seconds, 2);
  }
  return plain_number(total, 2) + " s" + listed + (listed.empty() ? "" : ")");
}

/// Root of the mean variance of pixels over the root of their mean square.
double expected_noise(const Image& radiance, const Image& variance, double samples) {
  double noise = 0.0, light = 0.0;
  for (std::size_t i = 0; i < radiance.pixels.size(); ++i) {
    noise += static_cast<double>(variance.pixels[i]) / samples;
    light += std::pow(static_cast<double>(radiance.pixels[i]), 2);
  }
  return light > 0.0 ? std::sqrt(noise / light) : 0.0;
}

std::string bought_by_paths(const RenderSpec& spec, const RenderOutput& picture) {
  double samples = static_cast<double>(spec.samples_per_pixel);
  if (const auto sampling = picture.counters.find("sampling"); sampling != picture.counters.end())
    samples = sampling->at("kept_samples_per_pixel").get<double>();
  const double noise = expected_noise(picture.image.layers.at(""), picture.image.layers.at("variance"), samples);
  return plain_number(samples, 3) + " paths per pixel, noise at most " + plain_number(100.0 * noise, 2) +
         " % of the light (RMS)";
}

std::string bought_by_prediction(const RenderSpec& spec) {
  const std::string samples = "sharp view of " + std::to_string(spec.samples_per_pixel) + " paths per pixel";
  if (spec.samples_per_pixel != samples_of_sharp_view || !spec.prediction.smooth) return samples;
  const auto known = std::find_if(std::begin(measured), std::end(measured),
                                  [&](const EqualPaths& m) { return m.kind == spec.prediction.kind; });
  return samples + ", in the shipped views as similar to the truth (SSIM) as " + known->samples +
         " path-traced samples";
}

}  // namespace

std::string cost_of(const RenderSpec& spec, const RenderOutput& picture) {
  const bool traced = spec.method == RenderMethod::PathTrace;
  return (traced ? "path traced in " : name_of(spec.prediction.kind) + " in ") + seconds_text(picture) + ": " +
         (traced ? bought_by_paths(spec, picture) : bought_by_prediction(spec));
}

}  // namespace sturm
