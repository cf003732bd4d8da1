#include "conoid/pictures/fragment_filter.h"

#include <algorithm>
#include <cmath>

#include "conoid/threads/parallel_for.h"

namespace sturm {
namespace {

using Eigen::Vector3f;

/// Three channels of direct light and three of indirect light, each followed by a zero: one vector register.
using Channels = float __attribute__((vector_size(32)));

Channels channels(const Vector3f& direct, const Vector3f& indirect) {
  return Channels{direct.x(), direct.y(), direct.z(), 0.0f, indirect.x(), indirect.y(), indirect.z(), 0.0f};
}
Vector3f direct_of(const Channels& c) {
  return {c[0], c[1], c[2]};
}
Vector3f indirect_of(const Channels& c) {
  return {c[4], c[5], c[6]};
}

Channels larger(const Channels& a, const Channels& b) {
  return a > b ? a : b;
}

/// The largest one of the direct and of the indirect channels, in all places of either.
Channels largest(const Channels& c) {
  const Channels pairs = larger(c, __builtin_shufflevector(c, c, 1, 0, 3, 2, 5, 4, 7, 6));
  return larger(pairs, __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1, 6, 7, 4, 5));
}

/// What is filtered of one fragment: radiance over `divisor`, and its variance.
struct Light {
  Channels value, variance;
};

/// What a fragment has to say on whether another one continues its surface.
struct Plane {
  Vector3f normal;
  float offset;       ///< of the plane from the eye [m]
  Vector3f position;  ///< from the eye [m]
  float pixel_size;   ///< there [m]
  float share;
  Vector3f albedo;
  bool lambertian;
  std::uint32_t fragment;  ///< of the view
};

/// What radiance is divided by: below 1e-3 a division would blow up noise. Light that a glossy surface reflects at once
/// knows no albedo.
Vector3f divisor(const Fragment& f) {
  return f.lambertian ? Vector3f(f.albedo.cwiseMax(1e-3f)) : Vector3f(Vector3f::Ones());
}

bool takes_part(const Fragment& f) {
  return !f.surroundings && !f.emits;
}

class Wavelet {
 public:
  Wavelet(const FragmentImage& view, double pixel_slope, const Eigen::Vector3d& eye_position,
          const FilterSettings& settings)
      : view_(view), settings_(settings) {
    const Vector3f eye = eye_position.cast<float>();
    first_.reserve(view.first.size());
    first_.push_back(0);
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        for (const Fragment& f : view.at(x, y)) {
          if (!takes_part(f)) continue;
          const Vector3f position = f.position - eye;
          planes_.push_back({f.normal, f.normal.dot(position), position,
                             static_cast<float>(pixel_slope) * position.norm(), f.share, f.albedo, f.lambertian,
                             static_cast<std::uint32_t>(&f - view.fragments.data())});
          const Vector3f by = divisor(f).cwiseInverse(), by_squared = by.cwiseAbs2();
          light_.push_back(
              {channels(f.direct.cwiseProduct(by), (f.radiance - f.direct).cwiseProduct(by)),
               channels(f.direct_variance.cwiseProduct(by_squared), f.indirect_variance.cwiseProduct(by_squared))});
        }
        first_.push_back(static_cast<std::uint32_t>(planes_.size()));
      }
  }

  FragmentImage run() {
    std::vector<Light> next(light_.size());
    tolerance_.resize(light_.size());
    for (int level = 0; level < settings_.levels; ++level) {
      for_all([&](int x, int y, std::uint32_t i) { tolerance_[i] = tolerance(x, y, i); });
      for_all([&](int x, int y, std::uint32_t i) { next[i] = smoothed(x, y, i, 1 << level); });
      light_.swap(next);
    }
    FragmentImage result = view_;
    for (std::size_t i = 0; i < light_.size(); ++i) {
      Fragment& f = result.fragments[planes_[i].fragment];
      const Vector3f albedo = divisor(f), squared = albedo.cwiseAbs2();
      f.direct = direct_of(light_[i].value).cwiseProduct(albedo);
      f.radiance = f.direct + indirect_of(light_[i].value).cwiseProduct(albedo);
      f.direct_variance = direct_of(light_[i].variance).cwiseProduct(squared);
      f.indirect_variance = indirect_of(light_[i].variance).cwiseProduct(squared);
    }
    return result;
  }

 private:
  static constexpr std::uint32_t none = ~0u;

  template <class Work>
  void for_all(const Work& work) const {
    parallel_for(0, view_.height, [&](int y) {
      for (int x = 0; x < view_.width; ++x) {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(x);
        for (std::uint32_t i = first_[pixel]; i < first_[pixel + 1]; ++i) work(x, y, i);
      }
    });
  }

  /// The fragment of a pixel that continues the surface of fragment i, `step` pixels away at most.
  std::uint32_t continued(int x, int y, const Plane& f, int step) const {
    if (x < 0 || y < 0 || x >= view_.width || y >= view_.height) return none;
    constexpr float same_way = 0.97f;  // cos 14°
    constexpr float same_albedo = 0.06f;
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(x);
    for (std::uint32_t j = first_[pixel]; j < first_[pixel + 1]; ++j) {
      const Plane& g = planes_[j];
      if (g.normal.dot(f.normal) < same_way || g.lambertian != f.lambertian) continue;
      if (!f.lambertian && (g.albedo - f.albedo).cwiseAbs().maxCoeff() > same_albedo) continue;
      if (std::abs(f.normal.dot(g.position) - f.offset) <= 0.5f * static_cast<float>(step) * f.pixel_size) return j;
    }
    return none;
  }

  /// Squares of the differences that count as noise. Variances estimated from few samples are noisy themselves: the
  /// mean over 3 × 3 pixels. Where all are alike to the last bit, rounding is noise.
  Channels tolerance(int x, int y, std::uint32_t i) const {
    Channels sum{};
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::uint32_t j = dx == 0 && dy == 0 ? i : continued(x + dx, y + dy, planes_[i], 2);
        if (j != none) sum += light_[j].variance, ++count;
      }
    const auto squared = [](double v) { return static_cast<float>(v * v); };
    const float d = squared(settings_.direct_tolerance), r = squared(settings_.indirect_tolerance);
    const Channels factors{d, d, d, d, r, r, r, r}, own = light_[i].value;
    return factors * sum / static_cast<float>(count) + 1e-12f * own * own + 1e-30f;
  }

  Light smoothed(int x, int y, std::uint32_t i, int step) const {
    constexpr float b3[3] = {3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f};
    const Channels own = light_[i].value, tolerance = tolerance_[i];
    Channels sum{}, variance{}, weights{};
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const std::uint32_t j = dx == 0 && dy == 0 ? i : continued(x + dx * step, y + dy * step, planes_[i], 2 * step);
        if (j == none) continue;
        const Light& other = light_[j];
        // (1 − x/4)⁴ is exp(−x) to 0.06, and ends at 4. The mean of both tolerances: who sees another is seen by it,
        // and a rare bright sample is neither left alone by its neighbours nor lost in them.
        const Channels difference = other.value - own,
                       off = difference * difference / (2.0f * (tolerance + tolerance_[j]));
        const Channels near = larger(1.0f - largest(off), Channels{}), square = near * near;
        const Channels weight = planes_[j].share * b3[std::abs(dx)] * b3[std::abs(dy)] * square * square;
        sum += weight * other.value;
        weights += weight;
        variance += weight * weight * other.variance;
      }
    return {sum / weights, variance / (weights * weights)};
  }

  const FragmentImage& view_;
  FilterSettings settings_;
  std::vector<std::uint32_t> first_;  ///< of the planes of each pixel, and one more
  std::vector<Plane> planes_;
  std::vector<Light> light_;
  std::vector<Channels> tolerance_;
};

}  // namespace

FragmentImage filtered(const FragmentImage& view, double pixel_slope, const Eigen::Vector3d& eye_position,
                       const FilterSettings& settings) {
  return Wavelet(view, pixel_slope, eye_position, settings).run();
}

}  // namespace sturm
