#include "compare/metrics/slanted_edge.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "compare/metrics/comparable.h"
#include "compare/metrics/luma.h"
#include "compare/statistics/sinc.h"
#include "io/files/error.h"

namespace sturm {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int bins_per_pixel = 4;
constexpr int smallest_side = 16;

/// Luma of the area, the edge running rather down than across.
struct Patch {
  int columns, rows;
  std::vector<double> values;

  double at(int x, int y) const { return values[static_cast<std::size_t>(y) * columns + x]; }
};

Patch cut(const Image& image, const PixelRectangle& area) {
  const std::vector<double> y = luma(image);
  Patch patch{area.width, area.height, {}};
  for (int row = 0; row < area.height; ++row)
    for (int column = 0; column < area.width; ++column)
      patch.values.push_back(y[static_cast<std::size_t>(area.y + row) * image.width + area.x + column]);
  return patch;
}

Patch transposed(const Patch& p) {
  Patch result{p.rows, p.columns, {}};
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.columns; ++x) result.values.push_back(p.at(y, x));
  return result;
}

/// Sum of the differences along x and along y: a steep edge has the larger one along x.
bool runs_down(const Patch& p) {
  double along_x = 0.0, along_y = 0.0;
  for (int y = 0; y < p.rows; ++y) along_x += (p.at(p.columns - 1, y) - p.at(0, y)) / p.rows;
  for (int x = 0; x < p.columns; ++x) along_y += (p.at(x, p.rows - 1) - p.at(x, 0)) / p.columns;
  return std::abs(along_x) >= std::abs(along_y);
}

double hamming(double offset, double half_width) {
  return std::abs(offset) > half_width ? 0.0 : 0.54 + 0.46 * std::cos(pi * offset / half_width);
}

/// x = place + slope·(row − middle row).
struct Line {
  double place = 0.0, slope = 0.0;
};

/// Centroid of the derivative of each row under a window about `guess`, then least squares. The second round has the
/// window on the edge.
Line fit_line(const Patch& p) {
  const double middle_row = 0.5 * (p.rows - 1), half = 0.5 * (p.columns - 1);
  Line line{half, 0.0};
  for (int round = 0; round < 3; ++round) {
    double rows = 0.0, places = 0.0, squares = 0.0, products = 0.0;
    std::vector<std::pair<double, double>> found;
    for (int y = 0; y < p.rows; ++y) {
      const double expected = line.place + line.slope * (y - middle_row);
      double weight = 0.0, moment = 0.0;
      for (int x = 0; x + 1 < p.columns; ++x) {
        const double w = hamming(x + 0.5 - expected, half) * (p.at(x + 1, y) - p.at(x, y));
        weight += w, moment += w * (x + 0.5);
      }
      if (weight != 0.0 && std::isfinite(moment / weight)) found.emplace_back(y - middle_row, moment / weight);
    }
    if (found.size() < 2) throw InputError("", "", "an area without an edge", "one straight edge");
    for (const auto& [row, place] : found) rows += row, places += place;
    rows /= static_cast<double>(found.size()), places /= static_cast<double>(found.size());
    for (const auto& [row, place] : found)
      squares += (row - rows) * (row - rows), products += (row - rows) * (place - places);
    line.slope = products / squares;
    line.place = places - line.slope * rows;
  }
  return line;
}

/// Values of the edge over the distance from it, in bins of a quarter pixel; empty bins take the mean of their
/// neighbours.
std::vector<double> edge_spread(const Patch& p, const Line& line) {
  const double cosine = 1.0 / std::hypot(1.0, line.slope), middle_row = 0.5 * (p.rows - 1);
  const double reach = std::min({line.place, p.columns - 1.0 - line.place}) - std::abs(line.slope) * middle_row;
  const int half = static_cast<int>(reach * cosine * bins_per_pixel);
  if (half < 4 * bins_per_pixel)
    throw InputError("", "", "an edge at the border of the area", "an edge with 4 pixels on either side in each row");
  std::vector<double> sums(2 * half), counts(2 * half);
  for (int y = 0; y < p.rows; ++y)
    for (int x = 0; x < p.columns; ++x) {
      const double distance = (x - line.place - line.slope * (y - middle_row)) * cosine;
      const int bin = static_cast<int>(std::floor(distance * bins_per_pixel)) + half;
      if (bin < 0 || bin >= 2 * half) continue;
      sums[bin] += p.at(x, y);
      counts[bin] += 1.0;
    }
  std::vector<double> edge(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::size_t low = i, high = i;
    while (low > 0 && counts[low] == 0.0) --low;
    while (high + 1 < counts.size() && counts[high] == 0.0) ++high;
    edge[i] = (sums[low] + (high == low ? 0.0 : sums[high])) /
              std::max(1.0, counts[low] + (high == low ? 0.0 : counts[high]));
  }
  return edge;
}

}  // namespace

EdgeMtf slanted_edge_mtf(const Image& image, const PixelRectangle& area, std::span<const double> frequencies) {
  require_finite(image, "image");
  if (area.x < 0 || area.y < 0 || std::min(area.width, area.height) < smallest_side ||
      area.x + area.width > image.width || area.y + area.height > image.height)
    throw InputError("", "",
                     "the area " + std::to_string(area.width) + " × " + std::to_string(area.height) + " at (" +
                         std::to_string(area.x) + ", " + std::to_string(area.y) + ")",
                     "at least 16 × 16 pixels inside the image");
  Patch patch = cut(image, area);
  EdgeMtf result;
  result.steep = runs_down(patch);
  if (!result.steep) patch = transposed(patch);
  const Line line = fit_line(patch);
  result.tilt_deg = std::atan(line.slope) * 180.0 / pi;
  const std::vector<double> edge = edge_spread(patch, line);
  result.step = edge.back() - edge.front();

  // Line spread: differences between neighbouring bins, under a window about the edge.
  std::vector<double> spread;
  const double half = 0.5 * static_cast<double>(edge.size());
  for (std::size_t i = 0; i + 1 < edge.size(); ++i)
    spread.push_back((edge[i + 1] - edge[i]) * hamming(static_cast<double>(i) + 1.0 - half, half));
  const double area_under = std::accumulate(spread.begin(), spread.end(), 0.0);
  if (!(std::abs(area_under) > 0.0)) throw InputError("", "", "an area without an edge", "one straight edge");
  for (const double f : frequencies) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < spread.size(); ++i)
      sum += spread[i] * std::polar(1.0, -2.0 * pi * f * static_cast<double>(i) / bins_per_pixel);
    const double bin_transfer = sinc(f / bins_per_pixel);
    result.frequencies.push_back(f);
    result.mtf.push_back(std::abs(sum) / std::abs(area_under) / (bin_transfer * bin_transfer));
  }
  return result;
}

}  // namespace sturm
