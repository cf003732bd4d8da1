#pragma once
#include "io/images/image.h"

namespace sturm {

/// Transfer functions of sRGB (IEC 61966-2-1) on [0, 1]; values beyond continue by the same formulas, negative ones on
/// the linear part.
float linear_to_srgb(float linear);
float srgb_to_linear(float encoded);  ///< the inverse of linear_to_srgb

/// Decodes an sRGB-encoded image; the last of 2 or 4 channels is alpha and stays as it is.
Image srgb_to_linear(const Image& encoded);

/// The display space of the metrics and of PNG files: clamp(exposure · x, 0, 1), then the sRGB transfer function. A NaN
/// stays NaN.
Image to_display(const Image& linear, double exposure);

/// Every value clamped to [0, 1]: what metrics with a peak of 1 need of linear light. A NaN stays NaN.
Image clamped(Image image);

}  // namespace sturm
