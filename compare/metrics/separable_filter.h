#pragma once
#include <opencv2/core/mat.hpp>
#include <span>

#include "io/images/image.h"

namespace sturm {

/// Correlation of a one-channel picture with along_x ⊗ along_y: an odd number of weights each, the middle one at the
/// pixel; the single weight 1 leaves a direction as it is. Pixels beyond the border repeat it. First along x, then
/// along y, and every sum runs from the first weight to the last. The same bits for any number of threads.
Image filtered(const Image& plane, std::span<const float> along_x, std::span<const float> along_y);

/// The same in double and in the calling thread, as part of a task of its own.
cv::Mat1d filtered(const cv::Mat1d& plane, std::span<const double> along_x, std::span<const double> along_y);

}  // namespace sturm
