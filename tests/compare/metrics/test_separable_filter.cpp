#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/metrics/separable_filter.h"
#include "io/images/opencv_view.h"

namespace sturm {
namespace {

Image textured_plane(int width, int height) {
  Image plane(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      *plane.at(x, y) = static_cast<float>(0.5 + 0.3 * std::sin(0.9 * x + 0.013 * x * y) + 0.2 * std::cos(1.7 * y));
  return plane;
}

/// Word by word: along x, then along y, each sum from the first weight to the last in the type of the values; the
/// border repeats.
template <class T>
std::vector<T> by_definition(const std::vector<T>& values, int width, int height, const std::vector<T>& along_x,
                             const std::vector<T>& along_y) {
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1));
  };
  std::vector<T> rows(values.size()), result(values.size());
  for (const bool second : {false, true})
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::vector<T>& weights = second ? along_y : along_x;
        const int radius = static_cast<int>(weights.size()) / 2;
        T sum = 0;
        for (int t = 0; t < static_cast<int>(weights.size()); ++t)
          sum += weights[static_cast<std::size_t>(t)] *
                 (second ? rows[index(x, y + t - radius)] : values[index(x + t - radius, y)]);
        (second ? result : rows)[index(x, y)] = sum;
      }
  return result;
}

const std::vector<float> symmetric{0.06f, 0.24f, 0.4f, 0.24f, 0.06f}, antisymmetric{0.7f, 0.3f, 0.0f, -0.3f, -0.7f},
    lopsided{0.1f, 0.2f, 0.7f}, single{1.0f};

TEST(SeparableFilter, HasTheBitsOfItsDefinition) {
  const Image plane = textured_plane(37, 150);  // more rows than one task takes
  for (const auto& x : {symmetric, antisymmetric, lopsided, single})
    for (const auto& y : {symmetric, antisymmetric, lopsided, single})
      EXPECT_EQ(filtered(plane, x, y).pixels, by_definition(plane.pixels, 37, 150, x, y));
}

TEST(SeparableFilter, RepeatsTheBorderOfPicturesSmallerThanTheWindow) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(2, 9), std::pair(9, 2)}) {
    const Image plane = textured_plane(width, height);
    const std::vector<float> wide(31, 1.0f / 31.0f);
    EXPECT_EQ(filtered(plane, wide, symmetric).pixels, by_definition(plane.pixels, width, height, wide, symmetric));
    EXPECT_EQ(filtered(plane, lopsided, wide).pixels, by_definition(plane.pixels, width, height, lopsided, wide));
  }
}

TEST(SeparableFilter, InDoubleToo) {
  const Image plane = textured_plane(23, 19);
  const std::vector<double> values(plane.pixels.begin(), plane.pixels.end()), x{0.1, 0.25, 0.3, 0.25, 0.1},
      y{0.3, 0.4, 0.3};
  const cv::Mat1d result = filtered(view(values, 23, 19), x, y);
  EXPECT_EQ(std::vector<double>(result.begin(), result.end()), by_definition(values, 23, 19, x, y));
}

TEST(SeparableFilter, SameBitsForAnyNumberOfThreads) {
  const Image plane = textured_plane(61, 400);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return filtered(plane, symmetric, symmetric).pixels;
  };
  EXPECT_EQ(with_threads(1), with_threads(4));
}

}  // namespace
}  // namespace sturm
