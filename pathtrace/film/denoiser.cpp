#include "pathtrace/film/denoiser.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sturm {

namespace {

constexpr float b3_spline[5] = {1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};
constexpr int albedo = 0, normal = 3, vergence = 6;  // places in the features of GuideStatistics

/// Sum of f(k) over three channels.
template <class Function>
float over_channels(const Function& f) {
  return f(0) + f(1) + f(2);
}

/// a/b for a ≥ 0, b ≥ 0: no difference costs nothing, even where nothing is allowed.
float cost(float a, float b) {
  if (!(a > 0.0f)) return 0.0f;
  return b > 0.0f ? a / b : std::numeric_limits<float>::infinity();
}

/// Binomial 3 × 3 mean: the variance of a pixel is itself noisy.
Image smoothed(const Image& variance) {
  Image out(variance.width, variance.height, variance.channels);
  tbb::parallel_for(0, variance.height, [&](int y) {
    for (int x = 0; x < variance.width; ++x)
      for (int k = 0; k < variance.channels; ++k) {
        float sum = 0.0f, weights = 0.0f;
        for (int v = std::max(0, y - 1); v <= std::min(variance.height - 1, y + 1); ++v)
          for (int u = std::max(0, x - 1); u <= std::min(variance.width - 1, x + 1); ++u) {
            const float weight = (u == x ? 2.0f : 1.0f) * (v == y ? 2.0f : 1.0f);
            sum += weight * variance.at(u, v)[k];
            weights += weight;
          }
        out.at(x, y)[k] = sum / weights;
      }
  });
  return out;
}

/// Smaller one of the one-sided differences of the vergence, per pixel across and down: within a surface where there is
/// one.
Image vergence_gradient(const Image& guide) {
  Image gradient(guide.width, guide.height, 2);
  const auto at = [&](int x, int y) {
    return guide.at(std::clamp(x, 0, guide.width - 1), std::clamp(y, 0, guide.height - 1))[vergence];
  };
  const auto smaller = [](float a, float b) { return std::abs(a) < std::abs(b) ? a : b; };
  for (int y = 0; y < guide.height; ++y)
    for (int x = 0; x < guide.width; ++x) {
      const float here = at(x, y);
      gradient.at(x, y)[0] = smaller(at(x + 1, y) - here, here - at(x - 1, y));
      gradient.at(x, y)[1] = smaller(at(x, y + 1) - here, here - at(x, y - 1));
    }
  return gradient;
}

class Filter {
 public:
  Filter(const DenoiserInput& input, const DenoiseSpec& spec)
      : input_(input),
        spec_(spec),
        gradient_(vergence_gradient(input.guide_mean)),
        radiance_(input.radiance),
        variance_(input.mean_variance),
        tolerance_(smoothed(variance_)) {}

  Image run() {
    for (int level = 0; level < spec_.levels; ++level) {
      pass(1 << level);
      tolerance_ = smoothed(variance_);
    }
    return std::move(radiance_);
  }

 private:
  void pass(int step) {
    Image radiance(radiance_.width, radiance_.height, 3), variance = radiance;
    tbb::parallel_for(0, radiance.height, [&](int y) {
      for (int x = 0; x < radiance.width; ++x) filter_pixel(x, y, step, radiance.at(x, y), variance.at(x, y));
    });
    radiance_ = std::move(radiance);
    variance_ = std::move(variance);
  }

  void filter_pixel(int x, int y, int step, float* radiance, float* variance) const {
    double sum[3] = {}, squares[3] = {}, weights = 0.0;
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        const int u = x + i * step, v = y + j * step;
        if (u < 0 || v < 0 || u >= radiance_.width || v >= radiance_.height) continue;
        const double weight = static_cast<double>(b3_spline[i + 2] * b3_spline[j + 2] * similarity(x, y, u, v));
        weights += weight;
        for (int k = 0; k < 3; ++k) {
          sum[k] += weight * static_cast<double>(radiance_.at(u, v)[k]);
          squares[k] += weight * weight * static_cast<double>(variance_.at(u, v)[k]);
        }
      }
    for (int k = 0; k < 3; ++k) {
      radiance[k] = static_cast<float>(sum[k] / weights);  // the middle tap alone has 9/64
      variance[k] = static_cast<float>(squares[k] / (weights * weights));
    }
  }

  float similarity(int x, int y, int u, int v) const {
    return std::exp(-(radiance_cost(x, y, u, v) + guide_cost(x, y, u, v)));
  }

  float radiance_cost(int x, int y, int u, int v) const {
    // The neighbour's own variance does not count: an outlier would excuse itself and be spread over the taps' pattern.
    const float *p = radiance_.at(x, y), *q = radiance_.at(u, v), *variance = tolerance_.at(x, y);
    const float difference = over_channels([&](int k) { return (p[k] - q[k]) * (p[k] - q[k]); });
    const float sigma = static_cast<float>(spec_.radiance_sigma);
    return cost(difference, sigma * sigma * 2.0f * over_channels([&](int k) { return variance[k]; }));
  }

  float guide_cost(int x, int y, int u, int v) const {
    const float *p = input_.guide_mean.at(x, y), *q = input_.guide_mean.at(u, v), *vp = input_.guide_variance.at(x, y),
                *vq = input_.guide_variance.at(u, v);
    const auto unexplained = [&](int feature) {
      return std::max(0.0f, over_channels([&](int k) {
                        const float d = p[feature + k] - q[feature + k];
                        return d * d - vp[feature + k] - vq[feature + k];
                      }));
    };
    const auto squared = [](double sigma) { return static_cast<float>(sigma * sigma); };
    const float slope =
        gradient_.at(x, y)[0] * static_cast<float>(u - x) + gradient_.at(x, y)[1] * static_cast<float>(v - y);
    const float nearer = std::max(p[vergence], q[vergence]), d = p[vergence] - q[vergence];
    const float depth = std::max(0.0f, d * d - slope * slope - vp[vergence] - vq[vergence]);
    return cost(unexplained(albedo), squared(spec_.albedo_sigma)) +
           cost(unexplained(normal), squared(spec_.normal_sigma)) +
           cost(depth, squared(spec_.vergence_sigma) * nearer * nearer);
  }

  const DenoiserInput& input_;
  const DenoiseSpec& spec_;
  Image gradient_, radiance_, variance_, tolerance_;
};

}  // namespace

Image denoised(const DenoiserInput& input, const DenoiseSpec& spec) {
  return Filter(input, spec).run();
}

Image denoised(const RenderResult& result, double samples_per_pixel, const DenoiseSpec& spec) {
  if (result.mean_variance.channels > 0)
    return denoised(DenoiserInput{result.radiance, result.mean_variance, result.guide_mean, result.guide_variance},
                    spec);
  Image mean_variance = result.variance;
  for (float& value : mean_variance.pixels) value = static_cast<float>(static_cast<double>(value) / samples_per_pixel);
  return denoised(DenoiserInput{result.radiance, mean_variance, result.guide_mean, result.guide_variance}, spec);
}

}  // namespace sturm
