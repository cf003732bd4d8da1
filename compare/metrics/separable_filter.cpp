#include "compare/metrics/separable_filter.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "io/images/opencv_view.h"

namespace sturm {

namespace {

/// Writes into `result`, which has the size of `plane`.
template <class T>
void filter(const cv::Mat& plane, const cv::Mat& result, std::span<const T> along_x, std::span<const T> along_y) {
  const cv::Point middle(static_cast<int>(along_x.size()) / 2, static_cast<int>(along_y.size()) / 2);
  std::vector<T> x(along_x.begin(), along_x.end()), y(along_y.begin(), along_y.end());
  // OpenCV would add up symmetric weights from the middle outwards, and some sizes in yet another order. With a zero
  // behind them they are not symmetric, and it takes them one after the other.
  x.push_back(T(0));
  y.push_back(T(0));
  cv::sepFilter2D(plane, result, plane.depth(), x, y, middle, 0.0, cv::BORDER_REPLICATE);
}

}  // namespace

Image filtered(const Image& plane, std::span<const float> along_x, std::span<const float> along_y) {
  constexpr int strip_rows = 64;  // that one task makes
  Image result(plane.width, plane.height, 1);
  const cv::Mat from = view(plane), to = view(result);
  tbb::parallel_for(0, (plane.height + strip_rows - 1) / strip_rows, [&](int strip) {
    const cv::Range rows(strip * strip_rows, std::min(plane.height, (strip + 1) * strip_rows));
    filter(from.rowRange(rows), to.rowRange(rows), along_x, along_y);  // sees the rows above and below
  });
  return result;
}

cv::Mat1d filtered(const cv::Mat1d& plane, std::span<const double> along_x, std::span<const double> along_y) {
  cv::Mat1d result(plane.size());
  filter(plane, result, along_x, along_y);
  return result;
}

}  // namespace sturm
