// The path tracer's loop for scenes with more than flat Lambertian surfaces, compiled once for Lambert alone and once
// for all models.
#include "pathtrace/integrator/path_tracer.h"
#include "pathtrace/lights/mis.h"
#include "pathtrace/sampling/vector_math.h"
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

namespace {

using Eigen::Vector3f;

struct DiffuseSurfaces {
  static BsdfValue evaluate(const SurfaceModel&, const Vector3f& out, const Vector3f& in, const Vector3f& albedo) {
    return out.z() < 0.0f ? Diffuse::evaluate(-out, -in, albedo) : Diffuse::evaluate(out, in, albedo);
  }
  static BsdfSample sample(const SurfaceModel&, const Vector3f& out, const BsdfNumbers& numbers,
                           const Vector3f& albedo) {
    BsdfSample s = Diffuse::sample(out, numbers, albedo);
    if (out.z() < 0.0f) s.in = -s.in;
    return s;
  }
  static bool only_sharp(const SurfaceModel&) { return false; }
  /// The side from which light matters to the choice of a light; 0: either.
  static Vector3f lit_side(const SurfacePoint& at, const Vector3f& direction) {
    return at.normal.dot(direction) < 0.0f ? at.normal : Vector3f(-at.normal);
  }
};

struct AnySurfaces {
  static BsdfValue evaluate(const SurfaceModel& model, const Vector3f& out, const Vector3f& in,
                            const Vector3f& albedo) {
    return sturm::evaluate(model, out, in, albedo);
  }
  static BsdfSample sample(const SurfaceModel& model, const Vector3f& out, const BsdfNumbers& numbers,
                           const Vector3f& albedo) {
    return sturm::sample(model, out, numbers, albedo);
  }
  static bool only_sharp(const SurfaceModel& model) { return sturm::only_sharp(model); }
  static Vector3f lit_side(const SurfacePoint&, const Vector3f&) { return Vector3f::Zero(); }
};

/// The local frame of a surface point for one viewing direction. Reflection and transmission are told apart by the
/// geometric normal, so that no light leaks through a smoothly shaded mesh [Veach1997, §5.3]; where the viewer sees the
/// front of the surface but the back of its shading normal, the geometric normal shades.
struct ShadingFrame {
  Vector3f geometric, normal, tangent, bitangent;

  ShadingFrame(const SurfacePoint& at, const Vector3f& out) : geometric(at.normal), normal(at.shading_normal) {
    if (!(normal.dot(out) * geometric.dot(out) > 0.0f)) normal = geometric;
    const TangentFrame frame(normal);
    tangent = frame.tangent;
    bitangent = frame.bitangent;
  }

  Vector3f to_local(const Vector3f& w) const { return {w.dot(tangent), w.dot(bitangent), w.dot(normal)}; }
  Vector3f to_world(const Vector3f& w) const { return w.x() * tangent + w.y() * bitangent + w.z() * normal; }

  /// True where both normals have the direction on the same side.
  bool agrees(const Vector3f& w) const { return w.dot(geometric) * w.dot(normal) > 0.0f; }

  /// Where a ray towards w starts; `unit` is the scene's (offset_from_surface).
  Vector3f origin(const Vector3f& position, const Vector3f& w, float unit) const {
    return offset_from_surface(position, w.dot(geometric) > 0.0f ? geometric : Vector3f(-geometric), unit);
  }
};

/// Blocks of four dimensions: the plain loop's three, and the choice of a lobe.
constexpr std::uint32_t dimensions_per_vertex = 4, lobe_dimension = 3;

std::uint32_t first_dimension_of(int bounce) {
  return dimension::first_vertex + dimensions_per_vertex * static_cast<std::uint32_t>(bounce);
}

/// What a path brings to its next vertex.
struct PathEnd {
  Vector3f direction = Vector3f::Zero(), throughput = Vector3f::Ones();
  float scatter_pdf = 0.0f, index_ratio_squared = 1.0f;
  bool sharp = true;  ///< lights cannot have been sampled in this direction before
};

/// Gives the path the direction in which the surface scatters it; false where it ends. `out` is where it came from, in
/// the frame.
template <class Surfaces>
bool go_on(PathEnd& path, const SurfacePoint& at, const ShadingFrame& frame, const Vector3f& out,
           const PixelSequence& sequence, std::uint32_t sample, int bounce, const RenderSettings& settings) {
  const std::uint32_t first_dimension = first_dimension_of(bounce);
  const auto u = sequence.pair(sample, first_dimension + dimension::scatter);
  const float lobe = unit_float(sequence.single(sample, first_dimension + lobe_dimension));
  const BsdfSample scattered =
      Surfaces::sample(at.material->surface, out, {unit_float(u.x), unit_float(u.y), lobe}, at.albedo);
  if (!(scattered.pdf > 0.0f)) return false;
  path.direction = frame.to_world(scattered.in).normalized();
  if (!frame.agrees(path.direction)) return false;
  path.throughput = path.throughput.cwiseProduct(scattered.weight);
  if (!(path.throughput.maxCoeff() > 0.0f)) return false;
  path.index_ratio_squared *= scattered.index_ratio_squared;
  if (bounce >= settings.first_roulette_bounce) {
    // Radiance inside glass is larger by the index squared; that is no reason to end or keep a path.
    const float survival = survival_probability(path.throughput.maxCoeff() * path.index_ratio_squared);
    if (unit_float(sequence.single(sample, first_dimension + dimension::survive)) >= survival) return false;
    path.throughput /= survival;
  }
  path.scatter_pdf = scattered.pdf;
  path.sharp = scattered.delta;
  return true;
}

}  // namespace

Vector3f PathTracer::light_share(const LightSample& light, const BsdfValue& value, const Vector3f& throughput,
                                 const Vector3f& position, const Vector3f& origin, RenderCounters& counters) const {
  const Vector3f towards = light.group < 0 ? Vector3f(position + light.direction - origin) : light.direction;
  const float weight = light.delta ? 1.0f : mis_weight(light.pdf, value.pdf);
  return (weight / light.pdf) *
         throughput.cwiseProduct(value.value).cwiseProduct(arriving(light, origin, towards, counters));
}

template <class Surfaces>
Vector3f PathTracer::surface_radiance(const SurfacePoint& first, const Vector3f& first_direction,
                                      VertexNumbers& numbers, std::uint32_t sample, RenderCounters& counters,
                                      const FirstVertex& known) const {
  const LightSet& lights = scene_.lights();
  SurfacePoint at = first;
  PathEnd path;
  path.direction = first_direction.normalized();
  const Vector3f &direction = path.direction, &throughput = path.throughput;
  Vector3f sum = Vector3f::Zero(), previous = Vector3f::Zero(), previous_normal = Vector3f::Zero();
  for (int bounce = 0;; ++bounce) {
    if (at.emitter >= 0 && at.normal.dot(direction) < 0.0f) {
      const float weight =
          bounce == 0 ? known.emission_weight
          : path.sharp
              ? 1.0f
              : mis_weight(path.scatter_pdf, lights.pdf(at.emitter, previous, previous_normal, at.position, at.normal));
      sum += weight * throughput.cwiseProduct(at.emission);
    }
    if (known.reflected_once && bounce <= 1) *known.reflected_once = sum;
    if (bounce == settings_.max_bounces) return sum;

    const SurfaceModel& surface = at.material->surface;
    const ShadingFrame frame(at, -direction);
    const Vector3f out = frame.to_local(-direction);
    const Vector3f lit_side = Surfaces::lit_side(at, direction);
    if (!lights.empty() && !Surfaces::only_sharp(surface)) {
      const auto u = numbers.sequence().pair(sample, first_dimension_of(bounce) + dimension::light);
      const LightSample light = lights.sample(at.position, lit_side, unit_float(u.x), unit_float(u.y));
      const Vector3f to_light = light.direction / light.distance;
      if (light.pdf > 0.0f && frame.agrees(to_light)) {
        const BsdfValue value = Surfaces::evaluate(surface, out, frame.to_local(to_light), at.albedo);
        if (value.value.maxCoeff() > 0.0f)
          sum += light_share(light, value, throughput, at.position,
                             frame.origin(at.position, to_light, scene_.offset_unit()), counters);
      }
    }
    if (known.reflected_once && bounce == 0) *known.reflected_once = sum;

    if (!go_on<Surfaces>(path, at, frame, out, numbers.sequence(), sample, bounce, settings_)) return sum;

    previous = at.position;
    previous_normal = lit_side;
    const Vector3f origin = frame.origin(at.position, direction, scene_.offset_unit());
    ++counters.bounce_rays;
    RTCRayHit ray = ray_from(origin, direction);
    if (!intersect(scene_.embree(), ray)) {
      if (!scene_.has_environment()) return sum;
      const float light_pdf = path.sharp ? 0.0f : lights.environment_pdf(direction);
      const float weight = light_pdf > 0.0f ? mis_weight(path.scatter_pdf, light_pdf) : 1.0f;
      sum += weight * throughput.cwiseProduct(scene_.environment(direction));
      if (known.reflected_once && bounce == 0) *known.reflected_once = sum;
      return sum;
    }
    at = scene_.surface_point(ray.hit, origin, direction, ray.ray.tfar);
  }
}

Vector3f PathTracer::diffuse_radiance(const SurfacePoint& first, const Vector3f& direction, VertexNumbers& numbers,
                                      std::uint32_t sample, RenderCounters& counters, const FirstVertex& known) const {
  return surface_radiance<DiffuseSurfaces>(first, direction, numbers, sample, counters, known);
}

Vector3f PathTracer::mixed_radiance(const SurfacePoint& first, const Vector3f& direction, VertexNumbers& numbers,
                                    std::uint32_t sample, RenderCounters& counters, const FirstVertex& known) const {
  return surface_radiance<AnySurfaces>(first, direction, numbers, sample, counters, known);
}

}  // namespace sturm
