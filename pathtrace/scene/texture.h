#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "io/images/image.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

namespace texture_axis {

/// A coordinate of any size → 0 … 1.
inline float within(float t, TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::Repeat:
      return t - std::floor(t);
    case TextureWrap::Mirror: {
      const float turn = t - 2.0f * std::floor(0.5f * t);
      return turn > 1.0f ? 2.0f - turn : turn;
    }
    default:
      return std::clamp(t, 0.0f, 1.0f);
  }
}

/// A texel beside the picture (−1 or n) → the one that is shown there.
inline int shown(int i, int n, TextureWrap wrap) {
  if (wrap == TextureWrap::Repeat) return i < 0 ? i + n : i >= n ? i - n : i;
  return std::clamp(i, 0, n - 1);  // a mirrored picture begins with the texel that it ended with
}

}  // namespace texture_axis

/// Looks up a texture; (0, 0) is the lower left corner of the image. `fetch(x, y)` is the value of a texel.
template <class Fetch>
auto looked_up(const Image& texture, const Eigen::Vector2f& uv, bool nearest, TextureWrap wrap_u, TextureWrap wrap_v,
               const Fetch& fetch) {
  using Value = decltype(fetch(0, 0));
  const auto at = [&](int x, int y) {
    return fetch(texture_axis::shown(x, texture.width, wrap_u), texture_axis::shown(y, texture.height, wrap_v));
  };
  const float x = texture_axis::within(uv.x(), wrap_u) * static_cast<float>(texture.width);
  const float y = (1.0f - texture_axis::within(uv.y(), wrap_v)) * static_cast<float>(texture.height);
  if (nearest) return at(static_cast<int>(x), static_cast<int>(y));
  const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
  const float fx = x - 0.5f - left, fy = y - 0.5f - top;
  const int ix = static_cast<int>(left), iy = static_cast<int>(top);
  const Value upper = (1.0f - fx) * at(ix, iy) + fx * at(ix + 1, iy),
              lower = (1.0f - fx) * at(ix, iy + 1) + fx * at(ix + 1, iy + 1);
  return Value((1.0f - fy) * upper + fy * lower);
}

/// Of a texture with 3 channels.
inline Eigen::Vector3f texel(const Image& texture, const Eigen::Vector2f& uv, bool nearest,
                             TextureWrap wrap_u = TextureWrap::Clamp, TextureWrap wrap_v = TextureWrap::Clamp) {
  return looked_up(texture, uv, nearest, wrap_u, wrap_v, [&](int x, int y) {
    const float* p = texture.at(x, y);
    return Eigen::Vector3f(p[0], p[1], p[2]);
  });
}

/// The same at a texture coordinate of the mesh.
inline Eigen::Vector3f texel(const Image& texture, const TextureMapping& mapping, const Eigen::Vector2f& coordinate,
                             bool nearest) {
  return texel(texture, mapping.picture_from_mesh * coordinate.homogeneous(), nearest, mapping.wrap_u, mapping.wrap_v);
}

/// Of a texture with 1 channel.
inline float grey_texel(const Image& texture, const TextureMapping& mapping, const Eigen::Vector2f& coordinate,
                        bool nearest) {
  return looked_up(texture, mapping.picture_from_mesh * coordinate.homogeneous(), nearest, mapping.wrap_u,
                   mapping.wrap_v, [&](int x, int y) { return *texture.at(x, y); });
}

}  // namespace sturm
