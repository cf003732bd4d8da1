#pragma once
#include <cstdint>
#include <optional>

#include "lensmodel/spectacles.h"

namespace sturm {

/// Whether a lens can be cut to its diameter.
enum class EdgeStatus : std::uint8_t {
  ok,              ///< there is glass everywhere inside of the rim
  surfaces_cross,  ///< front and back meet before the rim
  surface_ends     ///< one of the surfaces does not reach the rim
};

/// Thinnest and thickest place of a circle about the lens's axis [m], measured parallel to the axis. Negative where the
/// surfaces crossed.
struct ThicknessRange {
  double min, max;  ///< [m], min ≤ max
};

/// On the circle of radius `radius` [m]; none where a surface does not reach all of it.
std::optional<ThicknessRange> thickness_around(const Spectacles& lens, double radius);

/// How thick a lens is at its rim, and how far it can be cut.
struct EdgeThickness {
  EdgeStatus status = EdgeStatus::ok;  ///< whether it can be cut to its diameter
  std::optional<ThicknessRange> rim;   ///< only with status ok; a knife edge has min = 0
  double usable_diameter_m =
      0.0;  ///< the largest diameter inside of which there is glass everywhere; the rim's if the status is ok
};

/// What is left out: surfaces that cross and cross back within 1/256 of the radius.
EdgeThickness edge_thickness(const Spectacles& lens);

}  // namespace sturm
