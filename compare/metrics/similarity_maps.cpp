#include "compare/metrics/similarity_maps.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "compare/metrics/separable_filter.h"
#include "io/images/opencv_view.h"

namespace sturm {

namespace {

constexpr int radius = SimilarityMaps::margin, taps = 2 * radius + 1;
constexpr double sigma = 1.5, range = 1.0;
constexpr double c1 = (0.01 * range) * (0.01 * range), c2 = (0.03 * range) * (0.03 * range);
constexpr int strip_rows =
    32;  // rows of the map that one task makes; a fixed number, so that tasks never depend on the threads

std::array<double, taps> gaussian_window() {
  std::array<double, taps> w;
  for (int i = 0; i < taps; ++i) w[i] = std::exp(-0.5 * (i - radius) * (i - radius) / (sigma * sigma));
  const double sum = std::accumulate(w.begin(), w.end(), 0.0);
  for (double& x : w) x /= sum;
  return w;
}

struct Similarity {
  double whole, contrast_structure;
};

/// Of windowed x, y, x², y² and xy.
Similarity similarity(double mx, double my, double xx, double yy, double xy) {
  const double variance_x = xx - mx * mx, variance_y = yy - my * my, covariance = xy - mx * my;
  const double structure = 2.0 * covariance + c2, variance = variance_x + variance_y + c2;
  return {(2.0 * mx * my + c1) * structure / ((mx * mx + my * my + c1) * variance), structure / variance};
}

/// Windowed values of the pixels whose window lies inside.
cv::Mat1d windowed(const cv::Mat1d& values) {
  static const std::array<double, taps> window = gaussian_window();
  const cv::Rect inside(radius, radius, values.cols - 2 * radius, values.rows - 2 * radius);
  return filtered(values, window, window)(inside);
}

}  // namespace

SimilarityMaps similarity_maps(const std::vector<double>& x, const std::vector<double>& y, int width, int height) {
  const cv::Mat1d all_x = view(x, width, height), all_y = view(y, width, height);
  SimilarityMaps result;
  result.similarity = result.contrast_structure = Image(width - 2 * radius, height - 2 * radius, 1);
  const int rows = result.similarity.height, columns = result.similarity.width;
  std::vector<Similarity> row_sums(rows, {0.0, 0.0});

  tbb::parallel_for(0, (rows + strip_rows - 1) / strip_rows, [&](int strip) {
    const int first = strip * strip_rows, last = std::min(rows, first + strip_rows);
    const cv::Range under(first, last + 2 * radius);
    const cv::Mat1d a = all_x.rowRange(under), b = all_y.rowRange(under);
    const cv::Mat1d mx = windowed(a), my = windowed(b);
    const cv::Mat1d xx = windowed(a.mul(a)), yy = windowed(b.mul(b)), xy = windowed(a.mul(b));
    for (int row = first; row < last; ++row)
      for (int column = 0; column < columns; ++column) {
        const cv::Point at(column, row - first);
        const Similarity s = similarity(mx(at), my(at), xx(at), yy(at), xy(at));
        row_sums[row].whole += s.whole;
        row_sums[row].contrast_structure += s.contrast_structure;
        *result.similarity.at(column, row) = static_cast<float>(s.whole);
        *result.contrast_structure.at(column, row) = static_cast<float>(s.contrast_structure);
      }
  });
  double whole = 0.0, contrast_structure = 0.0;
  for (const Similarity& sum : row_sums) whole += sum.whole, contrast_structure += sum.contrast_structure;
  const double pixels = static_cast<double>(rows) * columns;
  result.similarity_mean = whole / pixels;
  result.contrast_structure_mean = contrast_structure / pixels;
  return result;
}

}  // namespace sturm
