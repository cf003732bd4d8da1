#pragma once
#include "pathtrace/guide/pupil_rectangle.h"

namespace sturm {

/// The pupil points that are proposed for one emitter at one place of the picture: uniform in a rectangle, cut to the
/// pupil.
struct PupilRegion {
  PupilRectangle rectangle{{0.0f, 0.0f}, {0.0f, 0.0f}};  ///< not empty
  Eigen::Vector2f v1, v2;                                ///< its axes, unit vectors

  /// A pupil point [m] from two uniform numbers; it may lie outside of the pupil.
  Eigen::Vector2f point(float u, float v) const {
    const Eigen::Vector2f t = rectangle.point(u, v);
    return t.x() * v1 + t.y() * v2;
  }

  /// Density of `point` [1/m²].
  float pdf(const Eigen::Vector2f& point) const {
    return rectangle.contains({v1.dot(point), v2.dot(point)}) ? proposed_pdf() : 0.0f;
  }

  /// The density where it is not 0 [1/m²].
  float proposed_pdf() const { return 1.0f / rectangle.area(); }
};

}  // namespace sturm
