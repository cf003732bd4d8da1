#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace sturm {

/// A rectangle of pupil points [m] on the right singular directions (v1, v2) of a map X = U diag(σ) Vᵀ from the pupil
/// to a plane.
struct PupilRectangle {
  Eigen::Vector2f low, high;

  /// All points t with |σ t − along| ≤ reach in either direction, cut to the square about the pupil. `along`: Uᵀ of the
  /// place in the plane [m]. Nothing is divided by zero: where σ = 0 it holds all of the pupil or nothing.
  static PupilRectangle that_reaches(const Eigen::Vector2f& along, const Eigen::Vector2f& sigma, float reach,
                                     float pupil_radius) {
    PupilRectangle r;
    for (int k = 0; k < 2; ++k) {
      if (sigma[k] * pupil_radius <= 1e-6f * reach) {
        r.low[k] = -pupil_radius;
        r.high[k] = std::abs(along[k]) <= reach ? pupil_radius : -pupil_radius;
        continue;
      }
      r.low[k] = std::max(-pupil_radius, (along[k] - reach) / sigma[k]);
      r.high[k] = std::min(pupil_radius, (along[k] + reach) / sigma[k]);
    }
    return r;
  }

  float area() const { return std::max(0.0f, high.x() - low.x()) * std::max(0.0f, high.y() - low.y()); }
  bool contains(const Eigen::Vector2f& t) const {
    return t.x() >= low.x() && t.x() <= high.x() && t.y() >= low.y() && t.y() <= high.y();
  }
  Eigen::Vector2f point(float u, float v) const {
    return {low.x() + u * (high.x() - low.x()), low.y() + v * (high.y() - low.y())};
  }

  /// False where the pupil's disc lies outside.
  bool meets_disc(float pupil_radius) const {
    const Eigen::Vector2f nearest(std::clamp(0.0f, low.x(), high.x()), std::clamp(0.0f, low.y(), high.y()));
    return !(nearest.squaredNorm() > pupil_radius * pupil_radius);
  }
};

}  // namespace sturm
