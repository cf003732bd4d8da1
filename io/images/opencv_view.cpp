#include "io/images/opencv_view.h"

#include <opencv2/core/utility.hpp>

namespace sturm {

namespace {

/// OpenCV has these settings once for the whole process.
void settle_opencv() {
  static const bool settled = [] {
    cv::setNumThreads(1);
    cv::setUseOptimized(false);
    return true;
  }();
  static_cast<void>(settled);
}

}  // namespace

cv::Mat view(Image& image) {
  settle_opencv();
  return {image.height, image.width, CV_32FC(image.channels), image.pixels.data()};
}

const cv::Mat view(const Image& image) {
  return view(const_cast<Image&>(image));
}

cv::Mat1d view(std::vector<double>& values, int width, int height) {
  settle_opencv();
  return {height, width, values.data()};
}

const cv::Mat1d view(const std::vector<double>& values, int width, int height) {
  return view(const_cast<std::vector<double>&>(values), width, height);
}

}  // namespace sturm
