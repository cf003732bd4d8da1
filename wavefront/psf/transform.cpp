#include "wavefront/psf/transform.h"

#include <opencv2/core.hpp>
#include <vector>

#include "io/images/opencv_view.h"

namespace sturm {

namespace {

/// A view settles OpenCV's threads and instructions (io/images/opencv_view.h), which a bare cv::Mat does not.
void settle() {
  std::vector<double> one(1);
  view(one, 1, 1);
}

}  // namespace

void transform(cv::Mat2d& field, int filled_rows) {
  settle();
  cv::dft(field, field, 0, filled_rows);
}

cv::Mat2d transform(const cv::Mat1d& samples) {
  settle();
  cv::Mat2d result;
  cv::dft(samples, result, cv::DFT_COMPLEX_OUTPUT);
  return result;
}

int quick_size(int n) {
  const int size = cv::getOptimalDFTSize(n);
  return size % 2 == 0 ? size : quick_size(n + 1);
}

}  // namespace sturm
