#include "wavefront/layers/unmixed_edges.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace sturm {

namespace {

using Eigen::Vector3f;

constexpr float like_colors = 1e-4f;  // squared difference below which the two sides of an edge tell no coverage
constexpr float little = 0.05f;
constexpr double rounding_of_depth = 1e-3;  // relative, of half floats
constexpr float doubt_of_place =
    1.0f / 48.0f;                // variance of a coverage between a half and one, of which no more is known
constexpr float unknown = 1e6f;  // doubt about a colour of which nothing is known

/// Of the channels of colours, by the mean of their squares. What sums of 25 colours in single precision leave of one
/// colour is none.
float variance_of(float mean_square, const Vector3f& mean) {
  constexpr float rounding = 25.0f / (1 << 24);
  const float variance = mean_square - mean.squaredNorm() / 3.0f;
  return variance > rounding * mean_square ? variance : 0.0f;
}

struct NearSurface {
  Vector3f color;
  double vergence_D;  // where it is continued to the pixel
  SurfaceSlope slope;
  float variance;  // of each channel
};

struct FarSurface {
  Vector3f color;
  float variance;  // of each channel
};

class EdgePixels {
 public:
  EdgePixels(LayeredPicture& picture, std::span<const PictureLayer> layers)
      : picture_(picture), layers_(layers), width_(picture.radiance.width), height_(picture.radiance.height) {}

  void unmix(std::span<const std::size_t> edges) {
    if (edges.empty() && layers_.empty()) return;
    if (picture_.coverage.empty()) picture_.coverage.assign(picture_.vergence_D.size(), 1.0f);
    for (int y = 0; y < height_ && !layers_.empty(); ++y)
      for (int x = 0; x < width_; ++x) take_what_is_told(x, y);
    for (const std::size_t i : edges)
      if (picture_.coverage[i] >= covers_all) unmix(static_cast<int>(i % width_), static_cast<int>(i / width_));
    for (const auto& [pixel, own] : parted_) std::copy_n(own.data(), 3, &picture_.radiance.pixels[3 * pixel]);
    std::stable_sort(picture_.hidden.begin(), picture_.hidden.end(), [](const HiddenPixel& a, const HiddenPixel& b) {
      return std::tie(a.y, a.x) < std::tie(b.y, b.x);
    });
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  double vergence(int x, int y) const { return picture_.vergence_D[index(x, y)]; }
  Vector3f color(int x, int y) const { return Vector3f(picture_.radiance.at(x, y)); }

  template <class Visit>
  void around(int x, int y, int distance, Visit visit) const {
    for (int v = std::max(0, y - distance); v <= std::min(height_ - 1, y + distance); ++v)
      for (int u = std::max(0, x - distance); u <= std::min(width_ - 1, x + distance); ++u) visit(u, v);
  }

  double farthest_beside(int x, int y) const {
    double farthest = vergence(x, y);
    around(x, y, 1, [&](int u, int v) { farthest = std::min(farthest, vergence(u, v)); });
    return farthest;
  }

  double nearest_beside(int x, int y) const {
    double nearest = vergence(x, y);
    around(x, y, 1, [&](int u, int v) { nearest = std::max(nearest, vergence(u, v)); });
    return nearest;
  }

  bool beside_farther(int x, int y) const { return vergence(x, y) - farthest_beside(x, y) > picture_.jump_D; }
  bool beside_nearer(int x, int y) const { return nearest_beside(x, y) - vergence(x, y) > picture_.jump_D; }

  /// Whether a layer says how much of a pixel the nearest surface beside it covers.
  bool nearer_is_told(int x, int y) const {
    const double nearest = nearest_beside(x, y);
    return std::any_of(layers_.begin(), layers_.end(), [&](const PictureLayer& layer) {
      return !layer.coverage.empty() && std::abs(layer.vergence_D[index(x, y)] - nearest) <= picture_.jump_D;
    });
  }

  /// The layer of the very surface that the picture shows in a pixel.
  const PictureLayer* own_layer(int x, int y) const {
    const double here = vergence(x, y);
    for (const PictureLayer& layer : layers_) {
      const double there = layer.vergence_D[index(x, y)];
      if (std::abs(there - here) <= rounding_of_depth * std::max(there, here) &&
          (layer.coverage.empty() || layer.coverage[index(x, y)] > 0.0f))
        return &layer;
    }
    return nullptr;
  }

  /// What layers of the pixel's own surface and of nearer ones say about its colour and coverage.
  void take_what_is_told(int x, int y) {
    const std::size_t i = index(x, y);
    float* const rgb = picture_.radiance.at(x, y);
    Vector3f rest(rgb);
    float before = 0.0f;
    for (const PictureLayer& layer : layers_)
      if (lies_before(layer, picture_, i)) {
        rest -= layer.coverage[i] * Vector3f(layer.radiance.at(x, y));
        before += layer.coverage[i];
      }
    const PictureLayer* const own = beside_nearer(x, y) && !nearer_is_told(x, y) ? nullptr : own_layer(x, y);
    const float covered = own && !own->coverage.empty() ? own->coverage[i] : 1.0f;
    if (own && (before > 0.0f || covered < covers_all)) {
      std::copy_n(own->radiance.at(x, y), 3, rgb);
      picture_.coverage[i] = std::min(picture_.coverage[i], covered);
    } else if (before > 0.0f && before < 1.0f - little) {
      Vector3f::Map(rgb) = (rest / (1.0f - before)).cwiseMax(0.0f);
    }
  }

  /// The unmixed pixels of the nearest surface about (x, y), if that is nearer than `than_D`; of a surface that has
  /// none, the mixed ones, which say nothing about its colour.
  std::optional<NearSurface> near_surface(int x, int y, double than_D) const {
    const double nearest = std::max(than_D, nearest_beside(x, y));
    for (const bool mixed : {false, true}) {
      NearSurface mean{Vector3f::Zero(), 0.0, {}, 0.0f};
      float weights = 0.0f, largest = 0.0f;
      around(x, y, mixed ? 1 : 2, [&](int u, int v) {
        if (std::abs(vergence(u, v) - nearest) > picture_.jump_D || beside_farther(u, v) != mixed) return;
        const float weight = 1.0f / static_cast<float>(std::max(1, (u - x) * (u - x) + (v - y) * (v - y)));
        mean.color += weight * color(u, v);
        mean.variance += weight * color(u, v).squaredNorm() / 3.0f;
        if (weight > largest) {
          mean.slope = surface_slope(picture_.vergence_D, width_, height_, u, v, picture_.jump_D);
          mean.vergence_D = vergence(u, v) + mean.slope.x * (x - u) + mean.slope.y * (y - v);
        }
        largest = std::max(largest, weight);
        weights += weight;
      });
      if (weights == 0.0f) continue;
      mean.color /= weights;
      mean.variance = mixed ? unknown : variance_of(mean.variance / weights, mean.color);
      return mean;
    }
    return std::nullopt;
  }

  /// The share of a pixel that a surface nearer than `behind_D` covers if its edge is straight, by the depth of the
  /// pixels about it.
  float coverage_by_place(int x, int y, double behind_D) const {
    float near = 0.0f, all_weights = 0.0f;
    around(x, y, 1, [&](int u, int v) {
      const auto weight = static_cast<float>((2 - std::abs(u - x)) * (2 - std::abs(v - y)));
      all_weights += weight;
      if (vergence(u, v) - behind_D > picture_.jump_D) near += weight;
    });
    return near / all_weights;
  }

  /// The colour of the layer that lies where `wanted` says, if one covers the pixel.
  template <class Wanted>
  std::optional<FarSurface> layer_color(int x, int y, Wanted wanted) const {
    const std::size_t i = index(x, y);
    const PictureLayer* nearest = nullptr;
    for (const PictureLayer& layer : layers_)
      if (wanted(layer.vergence_D[i]) && (!nearest || layer.vergence_D[i] > nearest->vergence_D[i]) &&
          (layer.coverage.empty() || layer.coverage[i] >= covers_all))
        nearest = &layer;
    if (!nearest) return std::nullopt;
    return FarSurface{Vector3f(nearest->radiance.at(x, y)), 0.0f};
  }

  /// The same of the picture's unmixed pixels about it.
  template <class Wanted>
  std::optional<FarSurface> seen_color(int x, int y, Wanted wanted) const {
    double nearest = -1.0;
    const auto usable = [&](int u, int v) { return wanted(vergence(u, v)) && !beside_nearer(u, v); };
    around(x, y, 2, [&](int u, int v) {
      if (usable(u, v)) nearest = std::max(nearest, vergence(u, v));
    });
    FarSurface mean{Vector3f::Zero(), 0.0f};
    float weights = 0.0f;
    around(x, y, 2, [&](int u, int v) {
      if (!usable(u, v) || nearest - vergence(u, v) > picture_.jump_D) return;
      const float weight = 1.0f / static_cast<float>(std::max(1, (u - x) * (u - x) + (v - y) * (v - y)));
      mean.color += weight * color(u, v);
      mean.variance += weight * color(u, v).squaredNorm() / 3.0f;
      weights += weight;
    });
    if (weights == 0.0f) return std::nullopt;
    mean.color /= weights;
    mean.variance = variance_of(mean.variance / weights, mean.color);
    return mean;
  }

  template <class Wanted>
  std::optional<FarSurface> far_surface(int x, int y, Wanted wanted) const {
    return layers_.empty() ? seen_color(x, y, wanted) : layer_color(x, y, wanted);
  }

  void unmix(int x, int y) {
    const double here = vergence(x, y);
    if (beside_nearer(x, y)) {
      if (nearer_is_told(x, y)) return;
      const auto behind = far_surface(x, y, [&](double v) { return std::abs(v - here) <= picture_.jump_D; });
      const auto near = near_surface(x, y, here);
      if (behind && near && near->vergence_D > here) part(x, y, *near, *behind, here, false);
    } else if (beside_farther(x, y) && !own_layer(x, y)) {
      const auto behind = far_surface(x, y, [&](double v) { return v < here - picture_.jump_D; });
      const auto near = near_surface(x, y, here);
      if (behind && near) part(x, y, *near, *behind, farthest_beside(x, y), true);
    }
  }

  /// Variance of the colour behind an edge. Where the pixels about it tell that colour, a pixel that no mixture
  /// explains may as well have another one of its own.
  float doubt_about_far(const FarSurface& far, float unexplained) const {
    return far.variance + (layers_.empty() && unexplained > like_colors ? unexplained : 0.0f);
  }

  /// Parts the pixel between a near surface and the colour behind it, whose vergence is `behind_D` or less.
  void part(int x, int y, const NearSurface& near, const FarSurface& far, double behind_D, bool near_in_front) {
    const Vector3f& behind = far.color;
    const Vector3f contrast = near.color - behind;
    const float square = std::max(contrast.squaredNorm(), 1e-12f);
    const float variance = near.variance + far.variance;
    if (!(square + 3.0f * variance > like_colors)) return;
    const std::size_t i = index(x, y);
    const Vector3f mixed = color(x, y);
    const float by_color = std::clamp((mixed - behind).dot(contrast) / square, 0.0f, 1.0f);
    // What a mixture of the two colours leaves unexplained says how far the colour of the near surface can be trusted.
    const float unexplained = (mixed - behind - by_color * contrast).squaredNorm() / 3.0f;
    const float doubt = (variance + unexplained) / square;
    const float far_doubt = doubt_about_far(far, std::max(0.0f, unexplained - near.variance));
    // Less would make the near surface darker than black; a colour that is in doubt tells nothing of the kind.
    const float least = far_doubt > 0.0f
                            ? 0.0f
                            : std::clamp(1.0f - (mixed.array() / behind.array().max(1e-12f)).minCoeff(), 0.0f, 1.0f);
    const float told = std::max(
        least, (by_color * doubt_of_place + coverage_by_place(x, y, behind_D) * doubt) / (doubt_of_place + doubt));
    // What a doubtful far surface leaves open stays where the depth map has it.
    const float kept = near_in_front ? 1.0f : 0.0f, trust = doubt_of_place / (doubt_of_place + far_doubt / square);
    const float alpha = kept + trust * (told - kept);
    if (far_doubt > 0.0f && std::abs(alpha - kept) < little) return;
    Vector3f own = near.color.cwiseMin(mixed / std::max(alpha, 1e-6f));  // no more than the pixel has
    const bool by_far_color = near_in_front || far_doubt == 0.0f || near.variance >= unknown;
    if (by_far_color && alpha > little) own = ((mixed - (1.0f - alpha) * behind) / alpha).cwiseMax(0.0f);
    if (near_in_front) {
      picture_.coverage[i] = alpha;
      parted_.emplace_back(i, own);
    } else if (alpha > 0.0f) {
      picture_.hidden.push_back(
          {x, y, near.vergence_D, alpha, {own.x(), own.y(), own.z()}, near.slope.x, near.slope.y});
      parted_.emplace_back(
          i, by_far_color ? behind : Vector3f(((mixed - alpha * own) / std::max(1.0f - alpha, little)).cwiseMax(0.0f)));
    }
  }

  LayeredPicture& picture_;
  std::span<const PictureLayer> layers_;
  int width_, height_;
  std::vector<std::pair<std::size_t, Vector3f>>
      parted_;  // new colours of pixels; neighbours are asked about the old ones
};

}  // namespace

void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers) {
  unmix_edges(picture, layers, edges_of(picture));
}

void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers, std::span<const std::size_t> edges) {
  EdgePixels(picture, layers).unmix(edges);
}

}  // namespace sturm
