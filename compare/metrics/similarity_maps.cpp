#include "compare/metrics/similarity_maps.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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

/// Windowed x, y, x², y², xy.
using Moments = std::array<double, 5>;

struct Similarity {
  double whole, contrast_structure;
};

Similarity similarity(const Moments& m) {
  const double mx = m[0], my = m[1];
  const double variance_x = m[2] - mx * mx, variance_y = m[3] - my * my, covariance = m[4] - mx * my;
  const double structure = 2.0 * covariance + c2, variance = variance_x + variance_y + c2;
  return {(2.0 * mx * my + c1) * structure / ((mx * mx + my * my + c1) * variance), structure / variance};
}

/// One row of the images filtered along x.
void filter_row(const double* x, const double* y, const std::array<double, taps>& w, std::vector<Moments>& out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    Moments sum{};
    for (int t = 0; t < taps; ++t) {
      const double a = x[i + t], b = y[i + t];
      sum[0] += w[t] * a, sum[1] += w[t] * b;
      sum[2] += w[t] * (a * a), sum[3] += w[t] * (b * b), sum[4] += w[t] * (a * b);
    }
    out[i] = sum;
  }
}

}  // namespace

SimilarityMaps similarity_maps(const std::vector<double>& x, const std::vector<double>& y, int width, int height) {
  const std::array<double, taps> w = gaussian_window();
  SimilarityMaps result;
  result.similarity = result.contrast_structure = Image(width - 2 * radius, height - 2 * radius, 1);
  const int rows = result.similarity.height, columns = result.similarity.width;
  std::vector<Similarity> row_sums(rows, {0.0, 0.0});

  tbb::parallel_for(0, (rows + strip_rows - 1) / strip_rows, [&](int strip) {
    const int first = strip * strip_rows, last = std::min(rows, first + strip_rows);
    std::vector<std::vector<Moments>> filtered(last - first + 2 * radius, std::vector<Moments>(columns));
    for (std::size_t i = 0; i < filtered.size(); ++i) {
      const std::size_t offset = (first + i) * width;
      filter_row(&x[offset], &y[offset], w, filtered[i]);
    }
    for (int row = first; row < last; ++row)
      for (int column = 0; column < columns; ++column) {
        Moments sum{};
        for (int t = 0; t < taps; ++t)
          for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += w[t] * filtered[row - first + t][column][k];
        const Similarity s = similarity(sum);
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
