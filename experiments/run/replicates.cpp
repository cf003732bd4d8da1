#include "experiments/run/replicates.h"

#include "compare/statistics/random_draws.h"

namespace sturm {

namespace {

Image mean_of(const std::vector<Image>& images, std::size_t first, std::size_t last, int left_out) {
  Image mean(images.front().width, images.front().height, images.front().channels);
  std::vector<double> sums(mean.pixels.size());
  int count = 0;
  for (std::size_t r = first; r < last; ++r) {
    if (static_cast<int>(r) == left_out) continue;
    ++count;
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += images[r].pixels[i];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) mean.pixels[i] = static_cast<float>(sums[i] / count);
  return mean;
}

/// Progress of part `index` of `count` equal parts.
ProgressFunction part_of(const ProgressFunction& progress, int index, int count) {
  return [&progress, index, count](double fraction) { progress((index + fraction) / count); };
}

}  // namespace

Image Replicates::mean(int left_out) const {
  return mean_of(images, 0, images.size(), left_out);
}
Image Replicates::first_half(int left_out) const {
  return mean_of(images, 0, images.size() / 2, left_out);
}
Image Replicates::second_half(int left_out) const {
  return mean_of(images, images.size() / 2, images.size(), left_out);
}

Image Replicates::variance_of_mean() const {
  const Image center = mean();
  std::vector<double> squares(center.pixels.size());
  for (const Image& image : images)
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double deviation = static_cast<double>(image.pixels[i]) - center.pixels[i];
      squares[i] += deviation * deviation;
    }
  Image variance(center.width, center.height, center.channels);
  const double n = static_cast<double>(images.size());
  for (std::size_t i = 0; i < squares.size(); ++i)
    variance.pixels[i] = static_cast<float>(squares[i] / (n * (n - 1.0)));
  return variance;
}

std::uint64_t replicate_seed(std::uint64_t seed, int index) {
  std::uint64_t own = next_random(seed) + static_cast<std::uint64_t>(index);
  return next_random(own);
}

Replicates render_replicates(const Scene& scene, const CameraPose& pose, const Eye& eye, RayModel model,
                             RenderSettings settings, std::uint64_t seed, int count, const ProgressFunction& progress) {
  Replicates replicates;
  for (int r = 0; r < count; ++r) {
    settings.seed = replicate_seed(seed, r);
    settings.progress = part_of(progress, r, count);
    replicates.images.push_back(path_trace(scene, pose, eye, model, settings).radiance);
  }
  return replicates;
}

PredictedReplicates predict_replicates(const Scene& scene, const CameraPose& pose, const Eye& eye,
                                       RenderSettings settings, std::uint64_t seed, int count,
                                       const ProgressFunction& progress) {
  PredictedReplicates result;
  for (int r = 0; r < count; ++r) {
    settings.seed = replicate_seed(seed, r);
    settings.progress = part_of(progress, r, count);
    PredictedImage predicted = predict(scene, pose, eye, 1, settings);
    result.predictions.images.push_back(std::move(predicted.prediction.radiance));
    result.sharp_views.push_back(std::move(predicted.source));
    result.times.sharp_view_seconds += predicted.times.sharp_view_seconds;
    result.times.spreading_seconds += predicted.times.spreading_seconds;
  }
  return result;
}

}  // namespace sturm
