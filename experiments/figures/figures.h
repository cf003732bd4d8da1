#pragma once
#include <vector>

#include "io/specs/experiment/figure_spec.h"
#include "reports/plots/figure.h"

namespace sturm {

/// The pictures that an experiment names, drawn. Throws InputError for a file that is not SVG and for a lens that has
/// no map.
std::vector<Figure> drawn_figures(const std::vector<FigureSpec>& specs);

}  // namespace sturm
