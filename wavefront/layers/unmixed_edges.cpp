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
constexpr float all = 0.999f, little = 0.05f;

struct NearSurface {
  Vector3f color;
  double vergence_D;
};

class EdgePixels {
 public:
  EdgePixels(LayeredPicture& picture, std::span<const PictureLayer> layers)
      : picture_(picture), layers_(layers), width_(picture.radiance.width), height_(picture.radiance.height) {}

  void unmix() {
    const Image radiance = picture_.radiance;  // as it was: neighbours are asked about it
    mixed_ = &radiance;
    if (picture_.coverage.empty()) picture_.coverage.assign(picture_.vergence_D.size(), 1.0f);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) unmix(x, y);
    std::stable_sort(picture_.hidden.begin(), picture_.hidden.end(), [](const HiddenPixel& a, const HiddenPixel& b) {
      return std::tie(a.y, a.x) < std::tie(b.y, b.x);
    });
  }

 private:
  double vergence(int x, int y) const { return picture_.vergence_D[static_cast<std::size_t>(y) * width_ + x]; }
  Vector3f color(int x, int y) const { return Vector3f(mixed_->at(x, y)); }

  template <class Visit>
  void around(int x, int y, int distance, Visit visit) const {
    for (int v = std::max(0, y - distance); v <= std::min(height_ - 1, y + distance); ++v)
      for (int u = std::max(0, x - distance); u <= std::min(width_ - 1, x + distance); ++u) visit(u, v);
  }

  bool beside_farther(int x, int y) const {
    bool found = false;
    around(x, y, 1, [&](int u, int v) { found |= vergence(x, y) - vergence(u, v) > picture_.jump_D; });
    return found;
  }

  bool beside_nearer(int x, int y) const {
    bool found = false;
    around(x, y, 1, [&](int u, int v) { found |= vergence(u, v) - vergence(x, y) > picture_.jump_D; });
    return found;
  }

  /// The unmixed pixels of the nearest surface about (x, y), if that is nearer than `than_D`.
  std::optional<NearSurface> near_surface(int x, int y, double than_D) const {
    double nearest = than_D;
    around(x, y, 1, [&](int u, int v) { nearest = std::max(nearest, vergence(u, v)); });
    NearSurface mean{Vector3f::Zero(), 0.0};
    int count = 0;
    around(x, y, 2, [&](int u, int v) {
      if (std::abs(vergence(u, v) - nearest) > picture_.jump_D || beside_farther(u, v)) return;
      mean.color += color(u, v);
      mean.vergence_D += vergence(u, v);
      ++count;
    });
    if (count == 0) return std::nullopt;
    return NearSurface{mean.color / static_cast<float>(count), mean.vergence_D / count};
  }

  /// The colour of the layer that lies where `wanted` says, if one covers the pixel.
  template <class Wanted>
  std::optional<Vector3f> layer_color(int x, int y, Wanted wanted) const {
    const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
    const PictureLayer* nearest = nullptr;
    for (const PictureLayer& layer : layers_)
      if (wanted(layer.vergence_D[i]) && (!nearest || layer.vergence_D[i] > nearest->vergence_D[i]) &&
          (layer.coverage.empty() || layer.coverage[i] >= all))
        nearest = &layer;
    if (!nearest) return std::nullopt;
    return Vector3f(nearest->radiance.at(x, y));
  }

  void unmix(int x, int y) {
    const double here = vergence(x, y);
    if (beside_nearer(x, y)) {
      const auto behind = layer_color(x, y, [&](double v) { return std::abs(v - here) <= picture_.jump_D; });
      const auto near = near_surface(x, y, here);
      if (behind && near && near->vergence_D > here) part(x, y, *near, *behind, false);
    } else if (beside_farther(x, y)) {
      const auto behind = layer_color(x, y, [&](double v) { return v < here - picture_.jump_D; });
      const auto near = near_surface(x, y, here);
      if (behind && near) part(x, y, *near, *behind, true);
    }
  }

  void part(int x, int y, const NearSurface& near, const Vector3f& behind, bool near_in_front) {
    const Vector3f contrast = near.color - behind;
    if (!(contrast.squaredNorm() > like_colors)) return;
    const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
    const Vector3f mixed = color(x, y);
    const float alpha = std::clamp((mixed - behind).dot(contrast) / contrast.squaredNorm(), 0.0f, 1.0f);
    const Vector3f own =
        alpha > little ? Vector3f((mixed - (1.0f - alpha) * behind) / alpha).cwiseMax(0.0f) : near.color;
    if (near_in_front) {
      picture_.coverage[i] = alpha;
      Eigen::Map<Vector3f>(picture_.radiance.at(x, y)) = own;
    } else if (alpha > 0.0f) {
      picture_.hidden.push_back({x, y, near.vergence_D, alpha, {own.x(), own.y(), own.z()}});
      Eigen::Map<Vector3f>(picture_.radiance.at(x, y)) = behind;
    }
  }

  LayeredPicture& picture_;
  std::span<const PictureLayer> layers_;
  int width_, height_;
  const Image* mixed_ = nullptr;
};

}  // namespace

void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers) {
  if (!layers.empty()) EdgePixels(picture, layers).unmix();
}

}  // namespace sturm
