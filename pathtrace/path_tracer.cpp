#include "pathtrace/path_tracer.h"

#include <numbers>

#include "pathtrace/embree_rays.h"
#include "pathtrace/mis.h"
#include "pathtrace/vector_math.h"

namespace sturm {

namespace {
constexpr float inverse_pi = std::numbers::inv_pi_v<float>;
}

Eigen::Vector3f PathTracer::arriving(const LightSample& light, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                                     RenderCounters& counters) const {
  ++counters.shadow_rays;
  if (light.group < 0) return occluded(scene_.embree(), origin, direction) ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : light.radiance;
  RTCRayHit ray = ray_from(origin, direction);
  if (!intersect(scene_.embree(), ray)) return Eigen::Vector3f::Zero();
  const SurfacePoint met = scene_.surface_point(ray.hit, origin, direction, ray.ray.tfar);
  const bool of_group = met.emitter >= 0 && scene_.lights().groups().group_of(met.emitter) == light.group;
  return of_group && met.normal.dot(direction) < 0.0f ? met.material->emission : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

Eigen::Vector3f PathTracer::direct_light(const SurfacePoint& at, const Eigen::Vector3f& normal, const Eigen::Vector3f& origin, float u,
                                         float v, RenderCounters& counters) const {
  const LightSample light = scene_.lights().sample(origin, normal, u, v);
  const float facing = normal.dot(light.direction);
  if (!(light.pdf > 0.0f) || !(facing > 0.0f)) return Eigen::Vector3f::Zero();
  const Eigen::Vector3f radiance = arriving(light, origin, light.direction, counters);
  const float cosine = facing / light.direction.norm();
  const float weight = light.delta ? 1.0f : mis_weight(light.pdf, cosine * inverse_pi);
  return (weight * cosine * inverse_pi / light.pdf) * at.albedo.cwiseProduct(radiance);
}

Eigen::Vector3f PathTracer::radiance(const SurfacePoint& first, const Eigen::Vector3f& direction, VertexNumbers& numbers,
                                     std::uint32_t sample, RenderCounters& counters, float first_emission_weight) const {
  switch (kind_) {
    case Scene::Kind::plain:
      return plain_radiance(first, direction, numbers, sample, counters, first_emission_weight);
    case Scene::Kind::diffuse:
      return diffuse_radiance(first, direction, numbers, sample, counters, first_emission_weight);
    default:
      return mixed_radiance(first, direction, numbers, sample, counters, first_emission_weight);
  }
}

Eigen::Vector3f PathTracer::plain_radiance(const SurfacePoint& first, const Eigen::Vector3f& first_direction, VertexNumbers& numbers,
                                           std::uint32_t sample, RenderCounters& counters, float first_emission_weight) const {
  SurfacePoint at = first;
  Eigen::Vector3f direction = first_direction, throughput = Eigen::Vector3f::Ones(), sum = Eigen::Vector3f::Zero();
  Eigen::Vector3f previous_origin = Eigen::Vector3f::Zero(), previous_normal = Eigen::Vector3f::Zero();
  float scatter_pdf = 0.0f;
  for (int bounce = 0;; ++bounce) {
    const bool seen_from_front = at.normal.dot(direction) < 0.0f;
    if (at.emitter >= 0 && seen_from_front) {
      const float weight =
          bounce == 0 ? first_emission_weight
                      : mis_weight(scatter_pdf, scene_.lights().pdf(at.emitter, previous_origin, previous_normal, at.position, at.normal));
      sum += weight * throughput.cwiseProduct(at.material->emission);
    }
    if (bounce == settings_.max_bounces || !(at.albedo.maxCoeff() > 0.0f)) return sum;

    const Eigen::Vector3f normal = seen_from_front ? at.normal : Eigen::Vector3f(-at.normal);
    const Eigen::Vector3f origin = offset_from_surface(at.position, normal);
    const VertexNumbers::Vertex random = numbers.vertex(sample, bounce);
    if (!scene_.lights().empty())
      sum += throughput.cwiseProduct(direct_light(at, normal, origin, random.light_u, random.light_v, counters));

    throughput = throughput.cwiseProduct(at.albedo);
    if (bounce >= settings_.first_roulette_bounce) {
      const float survival = survival_probability(throughput.maxCoeff());
      if (numbers.survive(sample, bounce) >= survival) return sum;
      throughput /= survival;
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
