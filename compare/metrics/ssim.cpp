#include "compare/metrics/ssim.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "compare/metrics/comparable.h"
#include "compare/metrics/luma.h"
#include "compare/statistics.h"
#include "io/error.h"

namespace sturm {

namespace {

constexpr int radius = 5, taps = 2 * radius + 1;
constexpr double sigma = 1.5, range = 1.0;
constexpr double c1 = (0.01 * range) * (0.01 * range), c2 = (0.03 * range) * (0.03 * range);
constexpr int strip_rows = 32;  // rows of the map that one task makes; a fixed number, so that tasks never depend on the threads

std::array<double, taps> gaussian_window() {
  std::array<double, taps> w;
  for (int i = 0; i < taps; ++i) w[i] = std::exp(-0.5 * (i - radius) * (i - radius) / (sigma * sigma));
  const double sum = std::accumulate(w.begin(), w.end(), 0.0);
  for (double& x : w) x /= sum;
  return w;
}

/// Windowed x, y, x², y², xy.
using Moments = std::array<double, 5>;

double similarity(const Moments& m) {
  const double mx = m[0], my = m[1];
  const double variance_x = m[2] - mx * mx, variance_y = m[3] - my * my, covariance = m[4] - mx * my;
  return (2.0 * mx * my + c1) * (2.0 * covariance + c2) / ((mx * mx + my * my + c1) * (variance_x + variance_y + c2));
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

Ssim ssim(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  if (test.width < taps || test.height < taps)
    throw InputError("", "", std::to_string(test.width) + " × " + std::to_string(test.height) + " pixels",
                     "at least 11 × 11 pixels for SSIM");
  const std::vector<double> x = luma(test), y = luma(reference);
  const std::array<double, taps> w = gaussian_window();
  Ssim result;
  result.map = Image(test.width - 2 * radius, test.height - 2 * radius, 1);
  const int rows = result.map.height, columns = result.map.width;
  std::vector<double> row_sums(rows);

  tbb::parallel_for(0, (rows + strip_rows - 1) / strip_rows, [&](int strip) {
    const int first = strip * strip_rows, last = std::min(rows, first + strip_rows);
    std::vector<std::vector<Moments>> filtered(last - first + 2 * radius, std::vector<Moments>(columns));
    for (std::size_t i = 0; i < filtered.size(); ++i) {
      const std::size_t offset = (first + i) * test.width;
      filter_row(&x[offset], &y[offset], w, filtered[i]);
    }
    for (int row = first; row < last; ++row)
      for (int column = 0; column < columns; ++column) {
        Moments sum{};
        for (int t = 0; t < taps; ++t)
          for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += w[t] * filtered[row - first + t][column][k];
        const double s = similarity(sum);
        row_sums[row] += s;
        *result.map.at(column, row) = static_cast<float>(s);
      }
  });
  result.mean = std::accumulate(row_sums.begin(), row_sums.end(), 0.0) / (static_cast<double>(rows) * columns);
  return result;
}

std::optional<double> ssim_mean_uncertainty(const Image& map, std::uint64_t seed, int resamples) {
  require_finite(map, "similarity map");
  constexpr int block = 16;
  struct Block {
    double sum = 0.0, pixels = 0.0;
  };
  const int across = (map.width + block - 1) / block, down = (map.height + block - 1) / block;
  if (across * down < 2) return std::nullopt;
  std::vector<Block> blocks(static_cast<std::size_t>(across) * down);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      Block& b = blocks[static_cast<std::size_t>(y / block) * across + x / block];
      b.sum += *map.at(x, y);
      b.pixels += 1.0;
    }
  const auto mean = [&](std::span<const std::size_t> indices) {
    Block total;
    for (const std::size_t i : indices) total.sum += blocks[i].sum, total.pixels += blocks[i].pixels;
    return total.sum / total.pixels;
  };
  return bootstrap_standard_error(blocks.size(), mean, resamples, seed);
}

}  // namespace sturm
