#pragma once
#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "pathtrace/sampling/disk.h"

namespace sturm {

/// Two unit vectors that complete the unit vector n to a right-handed frame (Duff et al., JCGT 6(1), 2017).
struct TangentFrame {
  Eigen::Vector3f tangent, bitangent;

  explicit TangentFrame(const Eigen::Vector3f& n) {
    const float sign = std::copysign(1.0f, n.z());
    const float a = -1.0f / (sign + n.z());
    const float b = n.x() * n.y() * a;
    tangent = {1.0f + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
    bitangent = {b, sign + n.y() * n.y() * a, -n.y()};
  }
};

/// A unit vector in the frame of a normal, which is its z.
struct LocalDirection {
  float x, y, z;
};

/// Direction with density cos θ / π (Malley's method).
inline LocalDirection cosine_local(float u, float v) {
  const auto d = concentric_disk(u, v);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - d.y * d.y))};
}

/// A local direction turned to the unit normal n.
inline Eigen::Vector3f direction_about(const Eigen::Vector3f& n, const LocalDirection& d) {
  const TangentFrame frame(n);
  return d.x * frame.tangent + d.y * frame.bitangent + d.z * n;
}

/// A point moved off its surface along n, so far that a ray from it cannot hit that surface again
/// (Wächter & Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019). Near a plane
/// through the origin, where steps of floating point say nothing, a fixed length takes their place: `unit`/65536 [m].
/// The unit is 1 m in a scene of metres and less in a smaller one (Scene::offset_unit).
inline Eigen::Vector3f offset_from_surface(const Eigen::Vector3f& p, const Eigen::Vector3f& n, float unit) {
  Eigen::Vector3f moved;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t steps = static_cast<std::int32_t>(256.0f * n[k]);
    const float stepped = std::bit_cast<float>(std::bit_cast<std::int32_t>(p[k]) + (p[k] < 0.0f ? -steps : steps));
    moved[k] = std::abs(p[k]) < unit * (1.0f / 32.0f) ? p[k] + unit * (1.0f / 65536.0f) * n[k] : stepped;
  }
  return moved;
}

/// Rec. 709 luminance.
inline float luminance(const Eigen::Vector3f& rgb) {
  return 0.2126f * rgb.x() + 0.7152f * rgb.y() + 0.0722f * rgb.z();
}

}  // namespace sturm
