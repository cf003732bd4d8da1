#pragma once
#include "io/images/image.h"

namespace sturm {

/// Root of the mean squared difference over all pixels and channels. Throws InputError as `require_comparable`.
double rmse(const Image& test, const Image& reference);

/// Peak signal-to-noise ratio 20·log10(peak/RMSE) [dB]; +∞ for equal images, which a caller writes as null.
/// `peak` > 0 is the largest value that the space can hold: 1 for display values and for linear values clamped to [0,
/// 1].
double psnr_dB(const Image& test, const Image& reference, double peak = 1.0);

}  // namespace sturm
