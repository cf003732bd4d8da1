#pragma once
#include <vector>

#include "stages/render_stage.h"

namespace sturm {

/// The same view rendered several times with independent seeds: the only honest source of a picture's noise
/// (docs/theory.md#73-noise-of-a-picture).
struct Replicates {
  std::vector<Image> images;

  /// Mean of all, or of all but number `left_out`.
  Image mean(int left_out = -1) const;

  /// Mean of the first half and of the second half of the images, or of all of them but number `left_out`.
  Image first_half(int left_out = -1) const;
  Image second_half(int left_out = -1) const;

  /// Variance of the mean of each pixel and channel, from the scatter between the replicates (at least two).
  Image variance_of_mean() const;
};

/// Seed of replicate number `index` of a run: independent of the seeds of other runs and replicates.
std::uint64_t replicate_seed(std::uint64_t seed, int index);

Replicates render_replicates(const Scene& scene, const CameraPose& pose, const Eye& eye, RayModel model,
                             RenderSettings settings, std::uint64_t seed, int count, const ProgressFunction& progress);

/// Predictions from independently seeded sharp views, and the seconds of all of them.
struct PredictedReplicates {
  Replicates predictions;
  std::vector<SharpView> sharp_views;  ///< that they were spread from
  PredictionTimes times;
};

PredictedReplicates predict_replicates(const Scene& scene, const CameraPose& pose, const Eye& eye,
                                       RenderSettings settings, std::uint64_t seed, int count,
                                       const ProgressFunction& progress);

}  // namespace sturm
