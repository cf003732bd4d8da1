#include "pathtrace/integrator/path_tracer.h"

#include <numbers>

#include "pathtrace/integrator/shadow_packet.h"
#include "pathtrace/lights/mis.h"
#include "pathtrace/sampling/vector_math.h"
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

namespace {
constexpr float inverse_pi = std::numbers::inv_pi_v<float>;

/// What multiplies albedo and radiance of a light sample at a Lambertian surface with this normal: (cos θ / π) / pdf by
/// the power heuristic against cosine sampling. 0: it cannot light it.
float lambertian_weight(const LightSample& light, const Eigen::Vector3f& normal) {
  const float facing = normal.dot(light.direction);
  if (!(light.pdf > 0.0f) || !(facing > 0.0f)) return 0.0f;
  const float ratio = facing * inverse_pi / (light.distance * light.pdf);
  return light.delta ? ratio : ratio * mis_weight(ratio);
}

/// The side of the surface from which a ray of this direction comes.
Eigen::Vector3f normal_towards(const SurfacePoint& at, const Eigen::Vector3f& direction) {
  return at.normal.dot(direction) < 0.0f ? at.normal : Eigen::Vector3f(-at.normal);
}
}  // namespace

Eigen::Vector3f PathTracer::arriving(const LightSample& light, const Eigen::Vector3f& origin,
                                     const Eigen::Vector3f& direction, RenderCounters& counters) const {
  ++counters.shadow_rays;
  if (light.group < 0 && light.varying < 0)
    return occluded(scene_.embree(), origin, direction) ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : light.radiance;
  RTCRayHit ray = ray_from(origin, direction);
  if (!intersect(scene_.embree(), ray)) return Eigen::Vector3f::Zero();
  const SurfacePoint met = scene_.surface_point(ray.hit, origin, direction, ray.ray.tfar);
  if (met.emitter < 0 || !(met.normal.dot(direction) < 0.0f)) return Eigen::Vector3f::Zero();
  const bool meant =
      light.varying >= 0 ? met.emitter == light.varying : scene_.lights().groups().group_of(met.emitter) == light.group;
  return meant ? met.emission : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

Eigen::Vector3f PathTracer::direct_light(const SurfacePoint& at, const Eigen::Vector3f& normal,
                                         const Eigen::Vector3f& origin, float u, float v,
                                         RenderCounters& counters) const {
  const LightSample light = scene_.lights().sample(origin, normal, u, v);
  const float weight = lambertian_weight(light, normal);
  if (!(weight > 0.0f)) return Eigen::Vector3f::Zero();
  return weight * at.albedo.cwiseProduct(arriving(light, origin, light.direction, counters));
}

void PathTracer::light(FirstVertices& vertices, const CameraHits& hits, std::uint32_t first_sample, int count,
                       VertexNumbers& numbers, RenderCounters& counters) const {
  vertices.lit = kind_ == Scene::Kind::plain && settings_.max_bounces > 0 && !scene_.lights().empty();
  if (!vertices.lit) return;
  for (int first = 0; first < count; first += ShadowPacket::size)
    light_packet(vertices, hits, first_sample, first, std::min(first + ShadowPacket::size, count), numbers, counters);
}

void PathTracer::light_packet(FirstVertices& vertices, const CameraHits& hits, std::uint32_t first_sample, int first,
                              int end, VertexNumbers& numbers, RenderCounters& counters) const {
  ShadowPacket shadows;
  for (int i = first; i < end; ++i) {
    Eigen::Vector3f& direct = vertices.direct_light[i];
    direct.setZero();
    if (!hits.hit(i) || !(vertices.at[i].albedo.maxCoeff() > 0.0f)) continue;
    const SurfacePoint& at = vertices.at[i];
    const Eigen::Vector3f normal = normal_towards(at, hits.direction(i)),
                          origin = offset_from_surface(at.position, normal, scene_.offset_unit());
    const VertexNumbers::Vertex random = numbers.vertex(first_sample + static_cast<std::uint32_t>(i), 0);
    const LightSample light = scene_.lights().sample(origin, normal, random.light_u, random.light_v);
    const float weight = lambertian_weight(light, normal);
    if (!(weight > 0.0f)) continue;
    if (light.group >= 0 || light.varying >= 0) {
      direct = weight * at.albedo.cwiseProduct(arriving(light, origin, light.direction, counters));
      continue;
    }
    ++counters.shadow_rays;
    direct = weight * at.albedo.cwiseProduct(light.radiance);
    shadows.add(i - first, origin, light.direction);
  }
  shadows.trace(scene_.embree());
  for (int i = first; i < end; ++i)
    if (shadows.is_stopped(i - first)) vertices.direct_light[i].setZero();
}

Eigen::Vector3f PathTracer::radiance(const SurfacePoint& first, const Eigen::Vector3f& direction,
                                     VertexNumbers& numbers, std::uint32_t sample, RenderCounters& counters,
                                     const FirstVertex& known) const {
  switch (kind_) {
    case Scene::Kind::plain:
      return plain_radiance(first, direction, numbers, sample, counters, known);
    case Scene::Kind::diffuse:
      return diffuse_radiance(first, direction, numbers, sample, counters, known);
    default:
      return mixed_radiance(first, direction, numbers, sample, counters, known);
  }
}

Eigen::Vector3f PathTracer::plain_radiance(const SurfacePoint& first, const Eigen::Vector3f& first_direction,
                                           VertexNumbers& numbers, std::uint32_t sample, RenderCounters& counters,
                                           const FirstVertex& known) const {
  SurfacePoint at = first;
  Eigen::Vector3f direction = first_direction, throughput = Eigen::Vector3f::Ones(), sum = Eigen::Vector3f::Zero();
  Eigen::Vector3f previous_origin = Eigen::Vector3f::Zero(), previous_normal = Eigen::Vector3f::Zero();
  float scatter_pdf = 0.0f;
  for (int bounce = 0;; ++bounce) {
    const bool seen_from_front = at.normal.dot(direction) < 0.0f;
    if (at.emitter >= 0 && seen_from_front) {
      const float weight = bounce == 0
                               ? known.emission_weight
                               : mis_weight(scatter_pdf, scene_.lights().pdf(at.emitter, previous_origin,
                                                                             previous_normal, at.position, at.normal));
      sum += weight * throughput.cwiseProduct(at.emission);
    }
    if (known.reflected_once && bounce <= 1) *known.reflected_once = sum;
    if (bounce == settings_.max_bounces || !(at.albedo.maxCoeff() > 0.0f)) return sum;

    const Eigen::Vector3f normal = normal_towards(at, direction);
    const Eigen::Vector3f origin = offset_from_surface(at.position, normal, scene_.offset_unit());
    const VertexNumbers::Vertex random = numbers.vertex(sample, bounce);
    if (bounce == 0 && known.direct_light)
      sum += *known.direct_light;
    else if (!scene_.lights().empty())
      sum += throughput.cwiseProduct(direct_light(at, normal, origin, random.light_u, random.light_v, counters));
    if (known.reflected_once && bounce == 0) *known.reflected_once = sum;

    throughput = throughput.cwiseProduct(at.albedo);
    if (bounce >= settings_.first_roulette_bounce) {
      const float survival = survival_probability(throughput.maxCoeff());
      if (numbers.survive(sample, bounce) >= survival) return sum;
      throughput *= 1.0f / survival;
    }

    direction = direction_about(normal, random.scatter);
    scatter_pdf = std::max(0.0f, normal.dot(direction)) * inverse_pi;
    ++counters.bounce_rays;
    RTCRayHit ray = ray_from(origin, direction);
    if (!intersect(scene_.embree(), ray) || !(scatter_pdf > 0.0f)) return sum;
    at = scene_.surface_point(ray.hit, origin, direction, ray.ray.tfar);
    previous_origin = origin;
    previous_normal = normal;
  }
}

}  // namespace sturm
