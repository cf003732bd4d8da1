#pragma once
// For .cpp files only: it brings OpenCV's headers with it.
#include <opencv2/core/mat.hpp>

namespace sturm {

/// Forward Fourier transform in place of a square field in double, e^(−2πi jk/N), unscaled. Rows from `filled_rows` on
/// are taken for zero, whatever they hold.
void transform(cv::Mat2d& field, int filled_rows);

/// That of real samples: complex, all frequencies.
cv::Mat2d transform(const cv::Mat1d& samples);

/// The least N ≥ n that it is quick for.
int quick_size(int n);

}  // namespace sturm
