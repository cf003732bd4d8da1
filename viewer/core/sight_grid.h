#pragma once
#include <vector>

#include "conoid/pictures/sight_field.h"

namespace sturm::viewer {

/// Nodes first + (i, j)·step in chief slopes, row by row: `SlopeGrid` in core_module.d.ts.
struct SlopeNodes {
  Eigen::Vector2d first, step;
  int columns = 0, rows = 0;
};

/// The sights of all nodes, 40 floats each. Every second node each way is traced; those between are cubic in the four
/// next on a line, or traced where the spectacles stop one of these or there are no four. Cubic ones are off by at most
/// (2·step)⁴/26 of the fourth derivative: with the page's steps by less than what the graphics card's straight
/// interpolation adds between nodes (docs/viewer.md, Speed). Nodes that the spectacles stop go on from those within, so
/// that places between follow the rim and not the grid (viewer/core/beyond_rim.h).
std::vector<float> sight_grid(const PicturePlane& head, const Eye& eye, const Spectacles* lens,
                              const SlopeNodes& nodes);

}  // namespace sturm::viewer
