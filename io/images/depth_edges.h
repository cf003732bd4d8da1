#pragma once
#include <cstddef>
#include <vector>

namespace sturm {

/// Pixels, ascending, beside which something lies behind or before them: the vergence of one of their eight neighbours
/// differs by more than `jump_D`. Most pictures have few. `vergence_D` has one value for each pixel, row by row.
std::vector<std::size_t> depth_edges(const std::vector<double>& vergence_D, int width, int height, double jump_D);

}  // namespace sturm
