#pragma once
#include <cstddef>
#include <vector>

#include "lensmodel/spectacles.h"

namespace sturm::viewer {

constexpr std::size_t floats_per_sight = 40;
constexpr std::size_t within_rim = 3;  ///< of these: more than 0 within the rim, less beyond it

/// How far within the rim a line of sight leaves the front surface, at `exit` [m, wearer frame]: 1 at the lens's axis,
/// 0 on the rim, > 0 for any that the spectacles let through. It is the front's rim that stops a ray that goes
/// outwards.
float margin_of(const Spectacles& lens, const Eigen::Vector3d& exit);

/// Gives nodes that the spectacles stop what those within would come to there: beside these by parabolas through the
/// three next on a line, farther away by straight lines. `numbers` of a grid, row by row, −1 in
/// `within_rim` of nodes to be filled; that number goes on as well, so that its zero between nodes is the rim. Where
/// light was lost inside of the rim (totally reflected, or past a surface), it is half-way.
void continue_beyond_rim(std::vector<float>& numbers, int columns, int rows);

}  // namespace sturm::viewer
