#pragma once
#include <string>
#include <vector>

#include "lensmodel/ellipse_layer.h"

namespace sturm {

/// The layers side by side as an SVG document. Each panel shows the picture plane to ± `half_width` and ± `half_height`
/// (tangents) with its angles; ellipses are drawn `drawn_scale` times as large as they are. [Kakimoto2010] fig. 12
std::string ellipse_layers_svg(const std::vector<EllipseLayer>& layers, double half_width, double half_height,
                               double drawn_scale, const std::string& label);

}  // namespace sturm
