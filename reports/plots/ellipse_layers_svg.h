#pragma once
#include <Eigen/Core>
#include <string>
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
  std::string title;
  std::vector<PlacedEllipse> ellipses;
};

/// The layers side by side as an SVG document. Each panel shows the picture plane to ± `half_width` and ± `half_height` (tangents) with its
/// angles; ellipses are drawn `drawn_scale` times as large as they are. [Kakimoto2010] fig. 12
std::string ellipse_layers_svg(const std::vector<EllipseLayer>& layers, double half_width, double half_height, double drawn_scale,
                               const std::string& label);

}  // namespace sturm
