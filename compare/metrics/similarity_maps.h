#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// The two maps that SSIM and MS-SSIM are means of [Wang2004 eqs. 6, 13], one channel each, for every pixel whose 11 ×
/// 11 window lies inside: (width − 10) × (height − 10); map pixel (x, y) belongs to image pixel (x + 5, y + 5).
struct SimilarityMaps {
  static constexpr int margin = 5;

  Image similarity;          ///< luminance · contrast · structure
  Image contrast_structure;  ///< (2σ_xy + C₂)/(σ_x² + σ_y² + C₂), without the luminance
  double similarity_mean = 1.0, contrast_structure_mean = 1.0;  ///< summed in double
};

/// Of two one-channel images of width × height ≥ 11 × 11 pixels: Gaussian window σ = 1.5 with 11 taps, K₁ = 0.01, K₂ =
/// 0.03, range 1, population covariance. The same bits for any number of threads.
SimilarityMaps similarity_maps(const std::vector<double>& x, const std::vector<double>& y, int width, int height);

}  // namespace sturm
