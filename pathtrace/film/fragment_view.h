#pragma once
#include <functional>
#include <optional>
#include <span>

#include "io/images/fragment_image.h"
#include "lensmodel/light_ray.h"
#include "pathtrace/film/render.h"

namespace sturm {

/// The chief ray (world) of a place [px] of a view; none where nothing is seen. Directions of any length.
using ChiefRays = std::function<std::optional<LightRay>(double x, double y)>;

/// A sharp view, path traced along chief rays that somebody else knows, with the surfaces of each pixel kept apart:
/// samples belong to one fragment while they lie on one plane, to a pixel's size, and face the same way within 25°, and
/// emit or not. `pixel_slope` is that size at a metre. Where a lamp begins 256 further samples per pixel measure how
/// much each fragment covers; they are not shaded. Samples are addressed by pixel and `settings.seed`: the same bits
/// for any number of threads.
FragmentImage render_fragments(const Scene& scene, int width, int height, const ChiefRays& chief_rays,
                               double pixel_slope, const RenderSettings& settings, RenderCounters& counters);

/// Rays of one place: its radiance is their mean.
struct PlaceRays {
  std::uint64_t key;                                              ///< addresses the place's random numbers
  std::vector<std::pair<Eigen::Vector3f, Eigen::Vector3f>> rays;  ///< origin and direction, at least one
};

/// Path traces `settings.samples_per_pixel` samples for each place, in turn along its rays.
std::vector<Eigen::Vector3f> shade_places(const Scene& scene, std::size_t count,
                                          const std::function<PlaceRays(std::size_t)>& place,
                                          const RenderSettings& settings, RenderCounters& counters);

}  // namespace sturm
