#include "pathtrace/lights/light_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pathtrace/sampling/vector_math.h"

namespace sturm {

namespace {
constexpr float pi = std::numbers::pi_v<float>;

/// 1 − cos of the half angle under which a sphere is seen, without cancellation for small ones.
float one_minus_cosine(float sine_squared) {
  return sine_squared / (1.0f + std::sqrt(std::max(0.0f, 1.0f - sine_squared)));
}

/// A sphere seen from outside: the cone about the axis to its centre.
struct Cone {
  Eigen::Vector3f axis;  // unit length
  float distance, cap;   // to the centre; 1 − cos of the half angle
  float pdf() const { return 1.0f / (2.0f * pi * cap); }
};

Cone cone_of(const Eigen::Vector3f& to_center, float square, float radius) {
  const float distance = std::sqrt(square);
  return {to_center / distance, distance, one_minus_cosine(radius * radius / square)};
}

/// A unit direction uniform in the cone, and what is needed to find where it meets the sphere.
struct ConeDirection {
  Eigen::Vector3f unit;
  float cosine, sine_squared;
};

ConeDirection direction_in(const Cone& cone, float u, float v) {
  const float drop = u * cone.cap, cosine = 1.0f - drop;
  const float sine_squared = drop * (2.0f - drop), sine = std::sqrt(sine_squared);
  const float angle = 2.0f * pi * v;
  const TangentFrame frame(cone.axis);
  return {cosine * cone.axis + sine * (std::cos(angle) * frame.tangent + std::sin(angle) * frame.bitangent), cosine,
          sine_squared};
}
}  // namespace

int LightSet::add_triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                           const Eigen::Vector3f& radiance, const TriangleTraits& traits) {
  const Eigen::Vector3f edge1 = b - a, edge2 = c - a;
  const Eigen::Vector3f scaled_normal = edge1.cross(edge2);
  const float area = 0.5f * scaled_normal.norm();
  lights_.push_back({Kind::triangle, a, edge1, edge2, scaled_normal, radiance, area, 0.0f, traits});
  power_.push_back(static_cast<double>(pi * area * luminance(radiance)));
  return size() - 1;
}

int LightSet::add_sphere(const Eigen::Vector3f& center, float radius, const Eigen::Vector3f& radiance) {
  const Eigen::Vector3f none = Eigen::Vector3f::Zero();
  lights_.push_back({Kind::sphere, center, {radius, 0.0f, 0.0f}, none, none, radiance, 0.0f, 0.0f});
  power_.push_back(static_cast<double>(4.0f * pi * pi * radius * radius * luminance(radiance)));
  return size() - 1;
}

int LightSet::add_point(const Eigen::Vector3f& position, const Eigen::Vector3f& intensity) {
  const Eigen::Vector3f none = Eigen::Vector3f::Zero();
  lights_.push_back({Kind::point, position, none, none, none, intensity, 0.0f, 0.0f});
  power_.push_back(static_cast<double>(4.0f * pi * luminance(intensity)));
  return size() - 1;
}

void LightSet::set_environment(std::shared_ptr<const EnvironmentMap> environment, float reach) {
  environment_ = std::move(environment);
  reach_ = reach;
}

LightShape LightSet::shape(int index) const {
  const Light& light = lights_[static_cast<std::size_t>(index)];
  if (light.kind == Kind::triangle)
    return {{light.a, light.a + light.edge1, light.a + light.edge2},
            light.a,
            0.0f,
            light.emission,
            light.traits.behind,
            light.traits.varies};
  return {{}, light.a, light.kind == Kind::sphere ? light.edge1.x() : 0.0f, light.emission};
}

void LightSet::leave_out(int light) {
  power_[static_cast<std::size_t>(light)] = 0.0;
  ++left_out_;
}

void LightSet::finish() {
  const bool none = left_out_ == size();
  if (environment_) environment_share_ = none ? 1.0f : 0.5f;
  lights_share_ = none ? 0.0f : 1.0f - environment_share_;
  groups_ = LightGroups(*this);
  for (int g = 0; g < groups_.size(); ++g) {
    const LightGroup& group = groups_.group(g);
    for (std::size_t k = 0; k < group.lights.size(); ++k)
      lights_[static_cast<std::size_t>(group.lights[k])].share = group.choices.probability(static_cast<int>(k));
  }
}

float LightSet::environment_pdf(const Eigen::Vector3f& direction) const {
  return environment_ ? environment_share_ * environment_->pdf(direction) : 0.0f;
}

LightSample LightSet::sample(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float u, float v) const {
  if (environment_) {
    if (u < environment_share_) {
      const EnvironmentSample s = environment_->sample(u / environment_share_, v);
      return {reach_ * s.direction, reach_, s.radiance, environment_share_ * s.pdf, false};
    }
    u = (u - environment_share_) / (1.0f - environment_share_);
  }
  LightGroups::Choice choice = groups_.choose(point, normal, u);
  choice.probability *= lights_share_;
  const LightGroup& group = groups_.group(choice.group);
  if (group.parallelogram) {
    const Eigen::Vector3f direction = group.corner + choice.rest * group.edge1 + v * group.edge2 - point;
    const float facing = -group.scaled_normal.dot(direction), square = direction.squaredNorm(),
                distance = std::sqrt(square);
    const Eigen::Vector3f& emission = lights_[static_cast<std::size_t>(group.lights.front())].emission;
    // pdf = 1/area · distance²/cos, with cos = facing / (area · distance)
    return {direction, distance, emission, facing > 0.0f ? choice.probability * square * distance / facing : 0.0f,
            false};
  }
  if (group.round) {
    const Eigen::Vector3f to_center = group.center - point;
    const float square = to_center.squaredNorm();
    if (square > group.radius * group.radius) {
      const Cone cone = cone_of(to_center, square, group.radius);
      return {direction_in(cone, choice.rest, v).unit, 1.0f,  Eigen::Vector3f::Zero(),
              choice.probability * cone.pdf(),         false, choice.group};
    }
  }
  const int member = group.choices.choose(choice.rest);
  const Light& light = lights_[static_cast<std::size_t>(group.lights[static_cast<std::size_t>(member)])];
  const float probability = choice.probability * light.share;
  switch (light.kind) {
    case Kind::triangle: {
      LightSample s = sample_triangle(light, probability, point, choice.rest, v);
      if (light.traits.varies) s.varying = group.lights[static_cast<std::size_t>(member)];
      return s;
    }
    case Kind::sphere:
      return sample_sphere(light, probability, point, choice.rest, v);
    default: {
      const Eigen::Vector3f direction = light.a - point;
      const float square = direction.squaredNorm();
      return {direction, std::sqrt(square), light.emission / square, probability, true};
    }
  }
}

LightSample LightSet::sample_triangle(const Light& light, float probability, const Eigen::Vector3f& point, float u,
                                      float v) {
  const float root = std::sqrt(u);
  const Eigen::Vector3f direction = light.a + (root * (1.0f - v)) * light.edge1 + (root * v) * light.edge2 - point;
  const float facing = -light.scaled_normal.dot(direction);
  const float square = direction.squaredNorm(), distance = std::sqrt(square);
  if (!(facing > 0.0f)) return {direction, distance, light.emission, 0.0f, false};
  // pdf = probability / area · distance² / cos, with cos = facing / (2·area·distance)
  return {direction, distance, light.emission, probability * 2.0f * square * distance / facing, false};
}

LightSample LightSet::sample_sphere(const Light& light, float probability, const Eigen::Vector3f& point, float u,
                                    float v) {
  const Eigen::Vector3f to_center = light.a - point;
  const float radius = light.edge1.x(), square = to_center.squaredNorm();
  if (square <= radius * radius) return {to_center, std::sqrt(square), light.emission, 0.0f, false};
  const Cone cone = cone_of(to_center, square, radius);
  const ConeDirection d = direction_in(cone, u, v);
  const float reach = cone.distance * d.cosine - std::sqrt(std::max(0.0f, radius * radius - square * d.sine_squared));
  return {reach * d.unit, reach, light.emission, probability * cone.pdf(), false};
}

float LightSet::pdf(int index, const Eigen::Vector3f& from, const Eigen::Vector3f& from_normal,
                    const Eigen::Vector3f& at, const Eigen::Vector3f& normal) const {
  const Light& light = lights_[static_cast<std::size_t>(index)];
  const LightGroup& group = groups_.group(groups_.group_of(index));
  const float probability = lights_share_ * groups_.probability(groups_.group_of(index), from, from_normal);
  if (light.kind == Kind::sphere || group.round) {
    const Eigen::Vector3f to_center = group.center - from;
    const float square = to_center.squaredNorm();
    if (square > group.radius * group.radius) return probability * cone_of(to_center, square, group.radius).pdf();
    if (light.kind == Kind::sphere) return 0.0f;
  }
  const Eigen::Vector3f direction = at - from;
  const float square = direction.squaredNorm(), facing = -normal.dot(direction);
  return facing > 0.0f ? probability * light.share * square * std::sqrt(square) / (facing * light.area) : 0.0f;
}

}  // namespace sturm
