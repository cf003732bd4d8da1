#pragma once
#include <functional>

#include "io/image.h"
#include "pathtrace/camera.h"
#include "pathtrace/guided_target.h"
#include "pathtrace/ray_model.h"
#include "pathtrace/scene.h"
#include "pathtrace/sequence.h"
#include "pathtrace/view_camera.h"

namespace sturm {

struct RenderSettings {
  int samples_per_pixel = 64;
  int max_bounces = 16;  ///< a path has at most max_bounces + 1 edges
  Sequence sequence = Sequence::Sobol;
  std::uint64_t seed = 1;
  bool guide_emitters = false;                    ///< one guided camera ray for each sample of a pixel that may see a small emitter
  int first_roulette_bounce = 2;                  ///< Russian roulette may end a path from this bounce on
  std::function<void(double fraction)> progress;  ///< called from worker threads as tiles finish; may be empty
};

struct RenderCounters {
  RayCounters camera;
  std::uint64_t bounce_rays = 0, shadow_rays = 0;
  std::uint64_t guided_rays = 0, guided_hits = 0;  ///< rays sent by an EmitterGuide or ViewGuide, and those that met their emitter
};

/// Layers of one size: radiance (3, mean over pixel and pupil), variance (3, of single samples), albedo (3), normal (3, world),
/// depth (1, nearest distance [m] as the camera counts it, ∞ where nothing was hit).
struct RenderResult {
  Image radiance, variance, albedo, normal, depth;
  RenderCounters counters;
  GuideUse guide_use = GuideUse::not_asked;
};

/// Path traces what the eye sees. The result is the same, bit for bit, for any number of threads.
/// Throws RuntimeFailure naming pixel, sample and seed if a sample is not finite.
RenderResult render(const Scene& scene, const EyeCamera& camera, const RenderSettings& settings);

/// The same through spectacles, another projection or pupil, or with turning eyes. What spectacles stop is black.
RenderResult render(const Scene& scene, const ViewCamera& camera, const RenderSettings& settings);

}  // namespace sturm
