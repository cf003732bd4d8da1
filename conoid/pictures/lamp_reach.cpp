#include "conoid/pictures/lamp_reach.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double margin_px = 1.5;  // half a pixel's diagonal for the pixel that looks, and as much for the sharp one

/// Raises the pixels whose centres lie in an ellipse to `value`.
void raise(Image& reach, const Vector2d& center, const Matrix2d& map, float value) {
  const Eigen::JacobiSVD<Matrix2d> svd(map, Eigen::ComputeFullU);
  const Vector2d axes = svd.singularValues().array() + margin_px;
  const Matrix2d to_disc = axes.cwiseInverse().asDiagonal() * svd.matrixU().transpose();
  const Vector2d half = (svd.matrixU() * axes.asDiagonal()).rowwise().norm();  // of the bounding box
  const auto clamped = [](double v, int end) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(end))); };
  const int x0 = clamped(center.x() - half.x(), reach.width), x1 = clamped(center.x() + half.x() + 1.0, reach.width);
  const int y0 = clamped(center.y() - half.y(), reach.height), y1 = clamped(center.y() + half.y() + 1.0, reach.height);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      float& pixel = *reach.at(x, y);
      if (pixel < value && (to_disc * (Vector2d(x + 0.5, y + 0.5) - center)).squaredNorm() <= 1.0) pixel = value;
    }
}

}  // namespace

bool at_lamp_rim(const FragmentImage& view, int x, int y, int reach) {
  bool lamp = false, other = false;
  for (int v = std::max(0, y - reach); v <= std::min(view.height - 1, y + reach); ++v)
    for (int u = std::max(0, x - reach); u <= std::min(view.width - 1, x + reach); ++u)
      for (const Fragment& f : view.at(u, v)) (f.emits ? lamp : other) = true;
  return lamp && other;
}

Image lamp_reach(const FragmentImage& view, int oversampling, const SightField& field) {
  Image reach(field.plane().width, field.plane().height, 1);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      for (const Fragment& lamp : view.at(x, y)) {
        if (!lamp.emits || !at_lamp_rim(view, x, y)) continue;
        const Vector2d place((x + 0.5) / oversampling, (y + 0.5) / oversampling);
        const Sight sight = field.at(place);
        if (!sight.reaches) continue;
        const double t =
            (lamp.position.cast<double>() - sight.origin).dot(sight.direction) / sight.direction.squaredNorm();
        const double vergence = t > 0.0 ? 1.0 / t : 0.0;
        const Matrix2d map =
            SightNeighbourhood(field, place, sight).picture_map(field.slopes(sight, vergence), vergence);
        raise(reach, place, field.eye().pupil_radius_m * map, lamp.radiance.maxCoeff());
      }
  return reach;
}

}  // namespace sturm
