#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "io/images/image.h"

namespace sturm {

/// Looks up a 3-channel texture; (0, 0) is the lower left corner of the image, coordinates are clamped at the border,
/// or the image repeats.
inline Eigen::Vector3f texel(const Image& texture, const Eigen::Vector2f& uv, bool nearest, bool repeat = false) {
  const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
  const auto fetch = [&](int x, int y) {
    if (repeat) {
      const float* p = texture.at(wrapped(x, texture.width), wrapped(y, texture.height));
      return Eigen::Vector3f(p[0], p[1], p[2]);
    }
    const float* p = texture.at(std::clamp(x, 0, texture.width - 1), std::clamp(y, 0, texture.height - 1));
    return Eigen::Vector3f(p[0], p[1], p[2]);
  };
  const auto within = [&](float t) { return repeat ? t - std::floor(t) : std::clamp(t, 0.0f, 1.0f); };
  const float x = within(uv.x()) * static_cast<float>(texture.width);
  const float y = (1.0f - within(uv.y())) * static_cast<float>(texture.height);
  if (nearest) return fetch(static_cast<int>(x), static_cast<int>(y));
  const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
  const float fx = x - 0.5f - left, fy = y - 0.5f - top;
  const int ix = static_cast<int>(left), iy = static_cast<int>(top);
  return (1.0f - fy) * ((1.0f - fx) * fetch(ix, iy) + fx * fetch(ix + 1, iy)) +
         fy * ((1.0f - fx) * fetch(ix, iy + 1) + fx * fetch(ix + 1, iy + 1));
}

}  // namespace sturm
