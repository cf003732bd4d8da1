#pragma once
#include <array>
#include <optional>

#include "io/images/image.h"

namespace sturm {

/// Structural similarity at five scales [Wang2003]: Π_{j<5} mean(contrast·structure at scale j)^β_j · mean(SSIM at
/// scale 5)^β_5, each scale half the one before (means of 2 × 2 pixels; an odd last row or column is left out), windows
/// as in SSIM.
struct MsSsim {
  static constexpr int scales = 5;  ///< the whole picture is the first
  static constexpr std::array<double, scales> exponents{0.0448, 0.2856, 0.3001, 0.2363,
                                                        0.1333};  ///< β of [Wang2003], from observers
  static constexpr int smallest_image_px = 11 << (scales - 1);    ///< 176: the coarsest scale still holds a window

  static constexpr int window_px = 11 << (scales - 1);  ///< what one value of the coarsest scale depends on, 176

  double value = 1.0;  ///< 0 where the mean at any scale is negative
  std::array<Image, scales>
      scale_maps;  ///< contrast·structure at scales 1 … 4, SSIM at scale 5; margins of 5 px of their scale

  /// The same product of local values, one channel, of the size of the image: where the similarity is lost. It shows
  /// the map of each scale as large pixels; its mean is not `value`.
  Image local_map(int width, int height) const;

  /// The value within a mask (one channel, weights ≥ 0) of the size of the image: means over each scale with the mask's
  /// own means of 2 × 2 pixels as weights. None where the mask leaves nothing of some scale.
  std::optional<double> within(const Image& mask) const;
};

/// None for images below 176 × 176 pixels. Luma, values in [0, 1] or thereabouts. Throws InputError as `ssim`.
std::optional<MsSsim> ms_ssim(const Image& test, const Image& reference);

}  // namespace sturm
