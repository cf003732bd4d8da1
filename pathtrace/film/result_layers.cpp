#include "pathtrace/film/result_layers.h"

namespace sturm {

RenderResult empty_result(int width, int height, const RenderSettings& settings) {
  RenderResult result;
  for (Image* layer : {&result.radiance, &result.variance, &result.albedo, &result.normal})
    *layer = Image(width, height, 3);
  result.depth = Image(width, height, 1);
  if (settings.relative_error) {
    result.samples = Image(width, height, 1);
    result.mean_variance = Image(width, height, 3);
  }
  if (settings.guide_layers)
    for (Image* layer : {&result.guide_mean, &result.guide_variance})
      *layer = Image(width, height, GuideStatistics::features);
  return result;
}

void store_radiance(RenderResult& result, int x, int y, const PixelStatistics& radiance) {
  for (int k = 0; k < 3; ++k) {
    result.radiance.at(x, y)[k] = static_cast<float>(radiance.mean(k));
    result.variance.at(x, y)[k] = static_cast<float>(radiance.variance(k));
  }
}

void store_first_hit(RenderResult& result, int x, int y, const FirstHitStatistics& first_hit,
                     const GuideStatistics& guide) {
  for (int k = 0; k < 3; ++k) {
    result.albedo.at(x, y)[k] = static_cast<float>(first_hit.albedo(k));
    result.normal.at(x, y)[k] = static_cast<float>(first_hit.normal(k));
  }
  *result.depth.at(x, y) = first_hit.depth();
  if (result.guide_mean.channels == 0) return;
  for (int k = 0; k < GuideStatistics::features; ++k) {
    result.guide_mean.at(x, y)[k] = static_cast<float>(guide.mean(k));
    result.guide_variance.at(x, y)[k] = static_cast<float>(guide.variance_of_mean(k));
  }
}

}  // namespace sturm
