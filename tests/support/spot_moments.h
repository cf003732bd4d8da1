#pragma once
#include <Eigen/Core>

#include "io/images/image.h"
#include "lensmodel/ellipse.h"

namespace sturm::testing {

struct Rectangle {
  int x, y, width, height;  ///< [px]
};

/// Second moments of a spot on a background that is taken from the rectangle's own edge, two pixels wide. Pixels count
/// by the mean of their channels. Frame: x right, y up; the variance of the pixel box is taken off.
struct SpotMoments {
  double sum;
  Eigen::Vector2d centroid_px;  ///< from the picture's upper left corner, y down
  Eigen::Matrix2d covariance_px;

  static SpotMoments of(const Image& image, const Rectangle& r) {
    constexpr int edge = 2;
    double background = 0.0, edge_pixels = 0.0;
    const auto value = [&](int x, int y) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += static_cast<double>(image.at(x, y)[k]) / 3.0;
      return sum;
    };
    const auto for_each = [&](auto&& visit) {
      for (int y = r.y; y < r.y + r.height; ++y)
        for (int x = r.x; x < r.x + r.width; ++x) visit(x, y);
    };
    for_each([&](int x, int y) {
      if (x >= r.x + edge && x < r.x + r.width - edge && y >= r.y + edge && y < r.y + r.height - edge) return;
      background += value(x, y);
      edge_pixels += 1.0;
    });
    background /= edge_pixels;
    SpotMoments m{0.0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    for_each([&](int x, int y) {
      m.sum += value(x, y) - background;
      m.centroid_px += (value(x, y) - background) * Eigen::Vector2d(x + 0.5, y + 0.5);
    });
    m.centroid_px /= m.sum;
    for_each([&](int x, int y) {
      const Eigen::Vector2d d(x + 0.5 - m.centroid_px.x(), m.centroid_px.y() - (y + 0.5));
      m.covariance_px += (value(x, y) - background) / m.sum * d * d.transpose();
    });
    m.covariance_px -= Eigen::Matrix2d::Identity() / 12.0;
    return m;
  }
};

}  // namespace sturm::testing
