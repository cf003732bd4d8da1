#pragma once
#include <cstdint>
#include <optional>

#include "io/images/image.h"
#include "pathtrace/cameras/eye_camera.h"
#include "pathtrace/cameras/general_camera.h"
#include "pathtrace/guide/guided_target.h"
#include "pathtrace/integrator/render_counters.h"
#include "pathtrace/integrator/render_settings.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// What a rendering in passes came to. Samples are counted over the picture.
struct PassSummary {
  int passes = 1;
  bool interrupted = false;  ///< ended by after_pass
  std::uint64_t samples_spent = 0, samples_kept = 0,
                samples_saved = 0;                ///< saved: against samples_per_pixel for every pixel
  std::uint64_t tiles = 0, tiles_converged = 0;   ///< of a rendering with relative_error
  std::uint64_t samples_of_longest = 0;           ///< had every tile gone on as long as the longest did
  std::optional<double> measured_relative_error;  ///< root of the relative MSE, from two independent halves
};

/// Layers of one size: radiance (3, mean over pixel and pupil), variance (3, of single samples), albedo (3), normal (3,
/// world), depth (1, nearest distance [m] as the camera counts it, ∞ where nothing was hit). Only with relative_error:
/// samples (1, kept) and mean_variance (3, unbiased estimate of the variance of `radiance`, with one degree of
/// freedom). Only with guide_layers: guide_mean and guide_variance (the features of GuideStatistics, and the variances
/// of these means).
struct RenderResult {
  Image radiance, variance, albedo, normal, depth;
  RenderCounters counters;
  GuideUse guide_use = GuideUse::not_asked;
  PassSummary passes;
  Image samples, mean_variance, guide_mean, guide_variance;
};

/// Path traces what the eye sees. The result is the same, bit for bit, for any number of threads, unless after_pass
/// ends it. Throws RuntimeFailure naming pixel, sample and seed if a sample is not finite.
RenderResult render(const Scene& scene, const EyeCamera& camera, const RenderSettings& settings);

/// The same through spectacles, another projection or pupil, or with turning eyes. What spectacles stop is black.
RenderResult render(const Scene& scene, const GeneralCamera& camera, const RenderSettings& settings);

}  // namespace sturm
