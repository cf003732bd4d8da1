#include "experiments/figures/blur_field_layers.h"

#include <cmath>

#include "reports/plots/ellipse_layers_svg.h"

namespace sturm {

std::string layers_svg(const BlurFieldSpec& spec, const TracedDirections& directions) {
  constexpr double drawn_scale = 3.0;
  return ellipse_layers_svg(ellipse_layers(spec, directions), std::tan(0.5 * spec.hfov), std::tan(0.5 * spec.vfov),
                            drawn_scale, "Blur ellipses over the field of view, one panel for each distance");
}

}  // namespace sturm
