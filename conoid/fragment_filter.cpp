#include "conoid/fragment_filter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace sturm {
namespace {

using Eigen::Vector3f;

/// What one fragment receives: radiance over albedo, and its variance.
struct Light {
  Vector3f value, variance;
};

/// Below this albedo a division would blow up noise; such a fragment is divided by this.
Vector3f divisor(const Vector3f& albedo) {
  return albedo.cwiseMax(1e-3f);
}

bool takes_part(const Fragment& f) {
  return !f.surroundings && !f.emits && f.albedo.maxCoeff() > 0.0f;
}

class Wavelet {
 public:
  Wavelet(const FragmentImage& view, double pixel_slope, const Eigen::Vector3d& eye_position, const FilterSettings& settings)
      : view_(view), settings_(settings), light_(view.fragments.size()), pixel_size_(view.fragments.size()) {
    const Vector3f eye = eye_position.cast<float>();
    for (std::size_t i = 0; i < light_.size(); ++i) {
      const Fragment& f = view.fragments[i];
      if (!takes_part(f)) continue;
      light_[i].value = f.radiance.cwiseQuotient(divisor(f.albedo));
      light_[i].variance = f.variance.cwiseQuotient(divisor(f.albedo).cwiseAbs2());
      pixel_size_[i] = static_cast<float>(pixel_slope) * (f.position - eye).norm();
    }
  }

  FragmentImage run() {
    for (int level = 0; level < settings_.levels; ++level) {
      std::vector<Light> next = light_;
      tbb::parallel_for(0, view_.height, [&](int y) {
        for (int x = 0; x < view_.width; ++x)
          for (const Fragment& f : view_.at(x, y))
            if (takes_part(f)) next[index(f)] = smoothed(x, y, f, 1 << level);
      });
      light_ = std::move(next);
    }
    FragmentImage result = view_;
    for (std::size_t i = 0; i < light_.size(); ++i) {
      Fragment& f = result.fragments[i];
      if (takes_part(f)) f.radiance = light_[i].value.cwiseProduct(divisor(f.albedo));
    }
    return result;
  }

 private:
  std::size_t index(const Fragment& f) const { return static_cast<std::size_t>(&f - view_.fragments.data()); }

  /// The fragment of a pixel that continues the surface of f, `step` pixels away at most; null without one.
  const Fragment* continued(int x, int y, const Fragment& f, int step) const {
    if (x < 0 || y < 0 || x >= view_.width || y >= view_.height) return nullptr;
    constexpr float same_way = 0.97f;  // cos 14°
    for (const Fragment& g : view_.at(x, y)) {
      if (!takes_part(g) || g.normal.dot(f.normal) < same_way) continue;
      if (std::abs(f.normal.dot(g.position - f.position)) <= 0.5f * static_cast<float>(step) * pixel_size_[index(f)]) return &g;
    }
    return nullptr;
  }

  Light smoothed(int x, int y, const Fragment& f, int step) const {
    constexpr float b3[3] = {3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f};
    const Light& own = light_[index(f)];
    // Channel by channel: the luma of a red glow is too dark to tell it from noise. A noiseless neighbourhood keeps 1e-6 of rounding.
    const float tolerance = static_cast<float>(settings_.tolerance);
    const Vector3f spread = tolerance * tolerance * mean_variance(x, y, f) + 1e-12f * own.value.cwiseAbs2();
    Vector3f sum = Vector3f::Zero(), variance = Vector3f::Zero();
    float weights = 0.0f;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const Fragment* g = dx == 0 && dy == 0 ? &f : continued(x + dx * step, y + dy * step, f, 2 * step);
        if (!g) continue;
        const Light& other = light_[index(*g)];
        float off = 0.0f;
        for (int c = 0; c < 3; ++c)
          if (spread[c] > 0.0f) off = std::max(off, (other.value[c] - own.value[c]) * (other.value[c] - own.value[c]) / spread[c]);
        const float weight = b3[std::abs(dx)] * b3[std::abs(dy)] * std::exp(-off);
        sum += weight * other.value;
        weights += weight;
        variance += weight * weight * other.variance;
      }
    return {sum / weights, variance / (weights * weights)};
  }

  /// Variances estimated from few samples are noisy themselves: the mean over 3 × 3 pixels.
  Vector3f mean_variance(int x, int y, const Fragment& f) const {
    Vector3f sum = Vector3f::Zero();
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (const Fragment* g = continued(x + dx, y + dy, f, 2)) sum += light_[index(*g)].variance, ++count;
    return count > 0 ? Vector3f(sum / static_cast<float>(count)) : light_[index(f)].variance;
  }

  const FragmentImage& view_;
  FilterSettings settings_;
  std::vector<Light> light_;
  std::vector<float> pixel_size_;
};

}  // namespace

FragmentImage filtered(const FragmentImage& view, double pixel_slope, const Eigen::Vector3d& eye_position, const FilterSettings& settings) {
  return Wavelet(view, pixel_slope, eye_position, settings).run();
}

}  // namespace sturm
