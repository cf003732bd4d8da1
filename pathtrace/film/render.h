#pragma once
#include <functional>

#include "io/images/image.h"
#include "io/specs/stop_spec.h"
#include "pathtrace/cameras/camera.h"
#include "pathtrace/cameras/ray_model.h"
#include "pathtrace/cameras/view_camera.h"
#include "pathtrace/guide/guided_target.h"
#include "pathtrace/sampling/sequence.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// How far a rendering in passes has come.
struct PassReport {
  double fraction = 0.0;                  ///< samples made, of those that samples_per_pixel allows
  std::function<Image()> picture_so_far;  ///< the radiance that would be kept if it ended now; valid during the call
};

struct RenderSettings {
  int samples_per_pixel = 64;
  int max_bounces = 16;  ///< a path has at most max_bounces + 1 edges
  Sequence sequence = Sequence::Sobol;
  std::uint64_t seed = 1;
  bool guide_emitters = false;                    ///< one guided camera ray for each sample of a pixel that may see a small emitter
  int first_roulette_bounce = 2;                  ///< Russian roulette may end a path from this bounce on
  Scene::Kind least_kind = Scene::Kind::plain;    ///< a scene of a simpler kind takes this one's loop, to measure what its own saves
  std::function<void(double fraction)> progress;  ///< called from worker threads as tiles finish; may be empty

  /// Root of the relative MSE at which to stop, at the latest after samples_per_pixel (≥ 8) samples; decided without bias, see
  /// pathtrace/film/adaptive_render.h. With `adaptive` per tile, else for the picture.
  std::optional<double> relative_error;
  std::optional<AdaptiveSpec> adaptive;
  bool end_converged_tiles = true;  ///< off, adaptive sampling lets all tiles go on until the picture is good enough
  bool guide_layers = false;        ///< fill RenderResult::guide_mean and guide_variance

  /// Called between passes, if it is not empty; false ends the rendering with what there is. Without it and without relative_error all
  /// samples of a pixel are made in one go.
  std::function<bool(const PassReport&)> after_pass;
};

struct RenderCounters {
  RayCounters camera;
  std::uint64_t bounce_rays = 0, shadow_rays = 0;
  std::uint64_t guided_rays = 0, guided_hits = 0;  ///< rays sent by an EmitterGuide or ViewGuide, and those that met their emitter

  RenderCounters& operator+=(const RenderCounters& part) {
    camera += part.camera;
    bounce_rays += part.bounce_rays;
    shadow_rays += part.shadow_rays;
    guided_rays += part.guided_rays;
    guided_hits += part.guided_hits;
    return *this;
  }
};

/// What a rendering in passes came to. Samples are counted over the picture.
struct PassSummary {
  int passes = 1;
  bool interrupted = false;                                              ///< ended by after_pass
  std::uint64_t samples_spent = 0, samples_kept = 0, samples_saved = 0;  ///< saved: against samples_per_pixel for every pixel
  std::uint64_t tiles = 0, tiles_converged = 0;                          ///< of a rendering with relative_error
  std::uint64_t samples_of_longest = 0;                                  ///< had every tile gone on as long as the longest did
  std::optional<double> measured_relative_error;                         ///< root of the relative MSE, from two independent halves
};

/// Layers of one size: radiance (3, mean over pixel and pupil), variance (3, of single samples), albedo (3), normal (3, world),
/// depth (1, nearest distance [m] as the camera counts it, ∞ where nothing was hit). Only with relative_error: samples (1, kept) and
/// mean_variance (3, unbiased estimate of the variance of `radiance`, with one degree of freedom). Only with guide_layers: guide_mean and
/// guide_variance (the features of GuideStatistics, and the variances of these means).
struct RenderResult {
  Image radiance, variance, albedo, normal, depth;
  RenderCounters counters;
  GuideUse guide_use = GuideUse::not_asked;
  PassSummary passes;
  Image samples, mean_variance, guide_mean, guide_variance;
};

/// Path traces what the eye sees. The result is the same, bit for bit, for any number of threads, unless after_pass ends it.
/// Throws RuntimeFailure naming pixel, sample and seed if a sample is not finite.
RenderResult render(const Scene& scene, const EyeCamera& camera, const RenderSettings& settings);

/// The same through spectacles, another projection or pupil, or with turning eyes. What spectacles stop is black.
RenderResult render(const Scene& scene, const ViewCamera& camera, const RenderSettings& settings);

}  // namespace sturm
