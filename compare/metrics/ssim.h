#pragma once
#include <cstdint>
#include <optional>

#include "io/images/image.h"

namespace sturm {

/// Structural similarity of the lumas [Wang, Bovik, Sheikh & Simoncelli 2004].
struct Ssim {
  double mean = 1.0;  ///< of the map, summed in double

  /// Similarity around each pixel whose window lies inside the image: (width − 10) × (height − 10), one channel; map
  /// pixel (x, y) belongs to image pixel (x + 5, y + 5).
  Image map;
};

/// Gaussian window σ = 1.5 with 11 taps, K₁ = 0.01, K₂ = 0.03, range 1 (values are expected in [0, 1] or thereabouts:
/// display space, or linear light clamped by the caller), population covariance. The same bits for any number of
/// threads. Throws InputError as `require_comparable`, and for images below 11 × 11 pixels or with neither 1 nor 3
/// channels.
Ssim ssim(const Image& test, const Image& reference);

/// Standard error of the mean of a similarity map by a bootstrap over blocks of 16 × 16 pixels (smaller ones at the
/// right and lower edge count with their area): neighbouring windows overlap, so pixels are no independent values. It
/// says how much the mean depends on which parts of the scene happen to be in view; what noise does to the mean is told
/// by the similarity of two seeds (the noise floor). None for a map of one block. Deterministic for a given seed.
std::optional<double> ssim_mean_uncertainty(const Image& map, std::uint64_t seed = 1, int resamples = 1000);

}  // namespace sturm
