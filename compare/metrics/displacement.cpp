#include "compare/metrics/displacement.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "compare/metrics/comparable.h"
#include "compare/metrics/luma.h"
#include "compare/metrics/separable_filter.h"

namespace sturm {

namespace {

constexpr double smoothing_px = 2.0;
constexpr int window = 6;  // three standard deviations: beyond them a Gaussian has 0.3 % of its weight
constexpr int smallest_px = 32;

std::array<float, 2 * window + 1> gaussian_weights() {
  std::array<float, 2 * window + 1> weights;
  double sum = 0.0;
  for (int i = -window; i <= window; ++i) sum += std::exp(-0.5 * i * i / (smoothing_px * smoothing_px));
  for (int i = -window; i <= window; ++i)
    weights[static_cast<std::size_t>(i + window)] =
        static_cast<float>(std::exp(-0.5 * i * i / (smoothing_px * smoothing_px)) / sum);
  return weights;
}

Image smoothed_luma(const Image& image) {
  static const auto weights = gaussian_weights();
  const std::vector<double> values = luma(image);
  Image plane(image.width, image.height, 1);
  for (std::size_t i = 0; i < values.size(); ++i) plane.pixels[i] = static_cast<float>(values[i]);
  return filtered(plane, weights, weights);
}

}  // namespace

std::optional<Eigen::Vector2d> displacement_px(const Image& test, const Image& reference) {
  require_colour_pair(test, reference);
  if (test.width < smallest_px || test.height < smallest_px) return std::nullopt;
  const Image t = smoothed_luma(test), r = smoothed_luma(reference);
  const auto mean = [&](int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y) * t.width + x;
    return 0.5 * (static_cast<double>(t.pixels[i]) + r.pixels[i]);
  };
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int y = window; y < t.height - window; ++y)
    for (int x = window; x < t.width - window; ++x) {
      const Eigen::Vector3d row(-0.5 * (mean(x + 1, y) - mean(x - 1, y)), -0.5 * (mean(x, y + 1) - mean(x, y - 1)),
                                mean(x, y));
      const std::size_t i = static_cast<std::size_t>(y) * t.width + x;
      normal += row * row.transpose();
      right += (static_cast<double>(t.pixels[i]) - r.pixels[i]) * row;
    }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return std::nullopt;
  return solver.solve(right).head<2>();
}

}  // namespace sturm
