#pragma once
#include <algorithm>

#include "pathtrace/render.h"
#include "pathtrace/vertex_numbers.h"

namespace sturm {

/// Radiance along one camera ray that has already been traced, by unidirectional path tracing with next-event estimation.
/// A scene of flat Lambertian surfaces without surroundings takes a loop of its own that knows no materials.
class PathTracer {
 public:
  PathTracer(const Scene& scene, const RenderSettings& settings)
      : scene_(scene), settings_(settings), kind_(std::max(scene.kind(), settings.least_kind)) {}

  /// `first` is what the camera ray origin + t·direction hit; `sample` belongs to the block of `numbers`. `first_emission_weight`
  /// multiplies what it emits itself (multiple importance sampling with guided camera rays).
  Eigen::Vector3f radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers, std::uint32_t sample,
                           RenderCounters& counters, float first_emission_weight = 1.0f) const;

 private:
  Eigen::Vector3f plain_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers, std::uint32_t sample,
                                 RenderCounters& counters, float first_emission_weight) const;

  /// For any scene; `Surfaces` evaluates and samples its surface models (path_tracer_surfaces.cpp).
  template <class Surfaces>
  Eigen::Vector3f surface_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                   std::uint32_t sample, RenderCounters& counters, float first_emission_weight) const;
  Eigen::Vector3f diffuse_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                   std::uint32_t sample, RenderCounters& counters, float first_emission_weight) const;
  Eigen::Vector3f mixed_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers, std::uint32_t sample,
                                 RenderCounters& counters, float first_emission_weight) const;
  Eigen::Vector3f direct_light(const SurfacePoint& at, const Eigen::Vector3f& normal, const Eigen::Vector3f& origin, float u, float v,
                               RenderCounters& counters) const;

  const Scene& scene_;
  const RenderSettings& settings_;
  Scene::Kind kind_;  ///< whose loop runs
};

}  // namespace sturm
