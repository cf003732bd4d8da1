#include "compare/metrics/ms_ssim.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "compare/metrics/comparable.h"
#include "compare/metrics/luma.h"
#include "compare/metrics/similarity_maps.h"
#include "io/images/opencv_view.h"

namespace sturm {

namespace {

/// Means of 2 × 2 pixels.
std::vector<double> halved(const std::vector<double>& values, int width, int height) {
  const int w = width / 2, h = height / 2;
  std::vector<double> result(static_cast<std::size_t>(w) * h);
  const cv::Mat even = view(values, width, height)(cv::Rect(0, 0, 2 * w, 2 * h));
  cv::resize(even, view(result, w, h), {w, h}, 0.0, 0.0, cv::INTER_AREA);
  return result;
}

}  // namespace

std::optional<MsSsim> ms_ssim(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  std::vector<double> x = luma(test), y = luma(reference);
  int width = test.width, height = test.height;
  if (std::min(width, height) < MsSsim::smallest_image_px) return std::nullopt;
  MsSsim result;
  for (int scale = 0; scale < MsSsim::scales; ++scale) {
    if (scale > 0) {
      x = halved(x, width, height), y = halved(y, width, height);
      width /= 2, height /= 2;
    }
    SimilarityMaps maps = similarity_maps(x, y, width, height);
    const bool coarsest = scale == MsSsim::scales - 1;
    result.value *= std::pow(std::max(0.0, coarsest ? maps.similarity_mean : maps.contrast_structure_mean),
                             MsSsim::exponents[scale]);
    result.scale_maps[scale] = std::move(coarsest ? maps.similarity : maps.contrast_structure);
  }
  return result;
}

Image MsSsim::local_map(int width, int height) const {
  Image map(width, height, 1);
  std::fill(map.pixels.begin(), map.pixels.end(), 1.0f);
  for (int scale = 0; scale < scales; ++scale) {
    const Image& local = scale_maps[scale];
    const float exponent = static_cast<float>(exponents[scale]);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int column = std::clamp((x >> scale) - SimilarityMaps::margin, 0, local.width - 1);
        const int row = std::clamp((y >> scale) - SimilarityMaps::margin, 0, local.height - 1);
        *map.at(x, y) *= std::pow(std::max(0.0f, *local.at(column, row)), exponent);
      }
  }
  return map;
}

std::optional<double> MsSsim::within(const Image& mask) const {
  std::vector<double> weights(mask.pixels.begin(), mask.pixels.end());
  int width = mask.width, height = mask.height;
  double product = 1.0;
  for (int scale = 0; scale < scales; ++scale) {
    if (scale > 0) {
      weights = halved(weights, width, height);
      width /= 2, height /= 2;
    }
    const Image& local = scale_maps[scale];
    double sum = 0.0, total = 0.0;
    for (int y = 0; y < local.height; ++y)
      for (int x = 0; x < local.width; ++x) {
        const double w =
            weights[static_cast<std::size_t>(y + SimilarityMaps::margin) * width + x + SimilarityMaps::margin];
        sum += w * *local.at(x, y);
        total += w;
      }
    if (!(total > 0.0)) return std::nullopt;
    product *= std::pow(std::max(0.0, sum / total), exponents[scale]);
  }
  return product;
}

}  // namespace sturm
