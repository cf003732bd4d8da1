#pragma once
#include <Eigen/Core>
#include <vector>

#include "lensmodel/ellipse.h"

namespace sturm {

/// One blur ellipse of a layer, both on the picture plane (tangents, right and up).
struct PlacedEllipse {
  Eigen::Vector2d centre;
  Ellipse ellipse;
};

/// The blur ellipses of all lines of sight at one distance.
struct EllipseLayer {
  double distance_m;  ///< may be infinite
  std::vector<PlacedEllipse> ellipses;
};

}  // namespace sturm
