#include "pathtrace/light_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pathtrace/vector_math.h"

namespace sturm {

namespace {
constexpr float pi = std::numbers::pi_v<float>;

/// 1 − cos of the half angle under which a sphere is seen, without cancellation for small ones.
float one_minus_cosine(float sine_squared) {
  return sine_squared / (1.0f + std::sqrt(std::max(0.0f, 1.0f - sine_squared)));
}
}  // namespace

int LightSet::add_triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c, const Eigen::Vector3f& radiance) {
  const Eigen::Vector3f edge1 = b - a, edge2 = c - a;
  const Eigen::Vector3f scaled_normal = edge1.cross(edge2);
  const float area = 0.5f * scaled_normal.norm();
  lights_.push_back({Kind::triangle, a, edge1, edge2, scaled_normal, radiance, area, 0.0f});
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
  if (light.kind == Kind::triangle) return {{light.a, light.a + light.edge1, light.a + light.edge2}, light.a, 0.0f, light.emission};
  return {{}, light.a, light.kind == Kind::sphere ? light.edge1.x() : 0.0f, light.emission};
}

void LightSet::leave_out(int light) {
  power_[static_cast<std::size_t>(light)] = 0.0;
  ++left_out_;
}

void LightSet::finish() {
  const bool none = left_out_ == size();
  if (environment_) environment_share_ = none ? 1.0f : 0.5f;
  choices_ = AliasTable(power_);
  const float share = none ? 0.0f : 1.0f - environment_share_;
  for (int i = 0; i < size(); ++i) lights_[i].probability = share * choices_.probability(i);
}

float LightSet::environment_pdf(const Eigen::Vector3f& direction) const {
  return environment_ ? environment_share_ * environment_->pdf(direction) : 0.0f;
}

LightSample LightSet::sample(const Eigen::Vector3f& point, float u, float v) const {
  if (environment_) {
    if (u < environment_share_) {
      const EnvironmentSample s = environment_->sample(u / environment_share_, v);
      return {reach_ * s.direction, s.radiance, environment_share_ * s.pdf, false};
    }
    u = (u - environment_share_) / (1.0f - environment_share_);
  }
  float rest = u;
  const int index = choices_.choose(rest);
  const Light& light = lights_[static_cast<std::size_t>(index)];
  switch (light.kind) {
    case Kind::triangle:
      return sample_triangle(light, point, rest, v);
    case Kind::sphere:
      return sample_sphere(light, point, rest, v);
    default: {
      const Eigen::Vector3f direction = light.a - point;
      return {direction, light.emission / direction.squaredNorm(), light.probability, true};
    }
  }
}

LightSample LightSet::sample_triangle(const Light& light, const Eigen::Vector3f& point, float u, float v) const {
  const float root = std::sqrt(u);
  const Eigen::Vector3f direction = light.a + (root * (1.0f - v)) * light.edge1 + (root * v) * light.edge2 - point;
  const float facing = -light.scaled_normal.dot(direction);
  if (!(facing > 0.0f)) return {direction, light.emission, 0.0f, false};
  const float square = direction.squaredNorm();
  // pdf = probability / area · distance² / cos, with cos = facing / (2·area·distance)
  return {direction, light.emission, light.probability * 2.0f * square * std::sqrt(square) / facing, false};
}

LightSample LightSet::sample_sphere(const Light& light, const Eigen::Vector3f& point, float u, float v) const {
  const Eigen::Vector3f to_center = light.a - point;
  const float radius = light.edge1.x(), square = to_center.squaredNorm();
  if (square <= radius * radius) return {to_center, light.emission, 0.0f, false};
  const float distance = std::sqrt(square), cap = one_minus_cosine(radius * radius / square);
  const float drop = u * cap, cosine = 1.0f - drop;  // uniform in the cone
  const float sine_squared = drop * (2.0f - drop), sine = std::sqrt(sine_squared);
  const float angle = 2.0f * pi * v;
  const Eigen::Vector3f axis = to_center / distance;
  const TangentFrame frame(axis);
  const Eigen::Vector3f unit = cosine * axis + sine * (std::cos(angle) * frame.tangent + std::sin(angle) * frame.bitangent);
  const float reach = distance * cosine - std::sqrt(std::max(0.0f, radius * radius - square * sine_squared));
  return {reach * unit, light.emission, light.probability / (2.0f * pi * cap), false};
}

float LightSet::pdf(int index, const Eigen::Vector3f& from, const Eigen::Vector3f& at, const Eigen::Vector3f& normal) const {
  const Light& light = lights_[static_cast<std::size_t>(index)];
  if (light.kind == Kind::sphere) {
    const float radius = light.edge1.x(), square = (light.a - from).squaredNorm();
    return square <= radius * radius ? 0.0f : light.probability / (2.0f * pi * one_minus_cosine(radius * radius / square));
  }
  const Eigen::Vector3f direction = at - from;
  const float square = direction.squaredNorm(), facing = -normal.dot(direction);
  return facing > 0.0f ? light.probability * square * std::sqrt(square) / (facing * light.area) : 0.0f;
}

}  // namespace sturm
