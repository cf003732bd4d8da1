#pragma once
#include <cstdint>
#include <vector>

#include "conoid/blur_field/field_grid.h"
#include "conoid/tracing/spectacle_conoid.h"

namespace sturm {

/// What need not be traced. Each switch changes the time, not the result.
struct DirectionShortcuts {
  bool rim = true;       ///< leave out lines of sight that certainly pass the lens outside of its rim
  bool symmetry = true;  ///< trace one quadrant where the lens is its own mirror image, left to right and up to down
};

/// What became of the directions of a grid.
struct DirectionCounters {
  std::uint64_t traced = 0;      ///< chief rays followed through the lens
  std::uint64_t mirrored = 0;    ///< directions taken from their mirror image
  std::uint64_t beyond_rim = 0;  ///< directions left out without tracing
  std::uint64_t usable = 0;      ///< directions with status ok
  std::uint64_t missed_lens = 0, total_internal_reflection = 0, no_convergence = 0;  ///< all others, by what happened
};

/// The conoids of all directions of a grid, in the order of FieldGrid::index. They hold for every distance and
/// accommodation.
struct TracedDirections {
  std::vector<SpectacleConoid> conoids;  ///< one for each direction; its status says whether it means anything
  DirectionCounters counters;            ///< of all of them
};

/// `lens` null is the naked eye: its conoids start at the pupil. Rows are shared out to threads; the result does not
/// depend on their number.
TracedDirections trace_directions(const Spectacles* lens, double rotation_center_m, const FieldGrid& grid,
                                  const DirectionShortcuts& shortcuts = {});

/// Whether a lens is its own mirror image left to right and up to down: surfaces of revolution, tori along the
/// horizontal or the vertical, in a straight mounting.
bool has_two_mirrors(const Spectacles& lens);

}  // namespace sturm
