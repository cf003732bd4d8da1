#pragma once
#include <algorithm>
#include <cmath>

#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/integrator/render_counters.h"
#include "pathtrace/integrator/render_settings.h"
#include "pathtrace/integrator/vertex_numbers.h"

namespace sturm {

/// Probability with which Russian roulette lets a path of this throughput go on: s(1.6 − 0.6 s) with s = √throughput,
/// within 0.06 of the cube root and cheaper. What comes to a path's end is multiplied by 1/p: with p = throughput the
/// paths that are left are all worth the same, but so few that their number is most of the noise. With the cube root
/// rays per sample rise by a sixth and squared errors fall by a third in the room of tests/reference/scene_plain.
inline float survival_probability(float throughput) {
  const float s = std::sqrt(std::min(1.0f, throughput));
  return std::min(0.95f, s * (1.6f - 0.6f * s));
}

/// What the camera rays of one block met first; only lanes that hit something are set.
struct FirstVertices {
  SurfacePoint at[CameraRayBlock::size];
  bool lit = false;  ///< direct_light is known
  Eigen::Vector3f direct_light[CameraRayBlock::size];
};

/// What is known of the first vertex of a path beforehand.
struct FirstVertex {
  float emission_weight = 1.0f;  ///< multiplies what it emits itself (multiple importance sampling with guided rays)
  const Eigen::Vector3f* direct_light = nullptr;  ///< what its light sample sends to the eye; null: not known
  Eigen::Vector3f* reflected_once =
      nullptr;  ///< gets what it emits, and what comes straight from lights and surroundings; null: unasked
};

/// Radiance along one camera ray that has already been traced, by unidirectional path tracing with next-event
/// estimation. A scene of flat Lambertian surfaces without surroundings takes a loop of its own that knows no
/// materials.
class PathTracer {
 public:
  PathTracer(const Scene& scene, const RenderSettings& settings)
      : scene_(scene), settings_(settings), kind_(std::max(scene.kind(), settings.least_kind)) {}

  /// Direct light of the first vertices of `count` camera rays, the block's samples from `first_sample` on. Their
  /// shadow rays start within a pixel's blur and go to the same lights, so they are traced in packets. Only in plain
  /// scenes; elsewhere nothing is done.
  void light(FirstVertices& vertices, const CameraHits& hits, std::uint32_t first_sample, int count,
             VertexNumbers& numbers, RenderCounters& counters) const;

  /// `first` is what the camera ray origin + t·direction hit; `sample` belongs to the block of `numbers`.
  Eigen::Vector3f radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                           std::uint32_t sample, RenderCounters& counters, const FirstVertex& known = {}) const;

 private:
  Eigen::Vector3f plain_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                 std::uint32_t sample, RenderCounters& counters, const FirstVertex& known) const;

  /// For any scene; `Surfaces` evaluates and samples its surface models (path_tracer_surfaces.cpp).
  template <class Surfaces>
  Eigen::Vector3f surface_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                   std::uint32_t sample, RenderCounters& counters, const FirstVertex& known) const;
  Eigen::Vector3f diffuse_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                   std::uint32_t sample, RenderCounters& counters, const FirstVertex& known) const;
  Eigen::Vector3f mixed_radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                 std::uint32_t sample, RenderCounters& counters, const FirstVertex& known) const;
  /// Radiance that a light sample sends to `origin` along `direction` (the sample's, from there) past everything in
  /// between.
  Eigen::Vector3f arriving(const LightSample& light, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                           RenderCounters& counters) const;
  /// What a path of the given throughput gains by a light sample as seen from `position`, where the surface scatters
  /// `value` of it; its shadow ray starts at `origin`.
  Eigen::Vector3f light_share(const LightSample& light, const BsdfValue& value, const Eigen::Vector3f& throughput,
                              const Eigen::Vector3f& position, const Eigen::Vector3f& origin,
                              RenderCounters& counters) const;
  void light_packet(FirstVertices& vertices, const CameraHits& hits, std::uint32_t first_sample, int first, int end,
                    VertexNumbers& numbers, RenderCounters& counters) const;
  Eigen::Vector3f direct_light(const SurfacePoint& at, const Eigen::Vector3f& normal, const Eigen::Vector3f& origin,
                               float u, float v, RenderCounters& counters) const;

  const Scene& scene_;
  const RenderSettings& settings_;
  Scene::Kind kind_;  ///< whose loop runs
};

}  // namespace sturm
