#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include "io/images/image.h"
#include "io/specs/stop_spec.h"
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
  bool guide_emitters = false;    ///< one guided camera ray for each sample of a pixel that may see a small emitter
  int first_roulette_bounce = 2;  ///< Russian roulette may end a path from this bounce on
  Scene::Kind least_kind =
      Scene::Kind::plain;  ///< a scene of a simpler kind takes this one's loop, to measure what its own saves
  std::function<void(double fraction)> progress;  ///< called from worker threads as tiles finish; may be empty

  /// Root of the relative MSE at which to stop, at the latest after samples_per_pixel (≥ 8) samples; decided without
  /// bias, see pathtrace/film/adaptive_render.h. With `adaptive` per tile, else for the picture.
  std::optional<double> relative_error;
  std::optional<AdaptiveSpec> adaptive;
  bool end_converged_tiles = true;  ///< off, adaptive sampling lets all tiles go on until the picture is good enough
  bool guide_layers = false;        ///< fill RenderResult::guide_mean and guide_variance

  /// Called between passes, if it is not empty; false ends the rendering with what there is. Without it and without
  /// relative_error all samples of a pixel are made in one go.
  std::function<bool(const PassReport&)> after_pass;
};

}  // namespace sturm
