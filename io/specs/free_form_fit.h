#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "lensmodel/bspline_fit.h"
#include "lensmodel/surface_power.h"

namespace sturm {

/// How well a free-form surface holds what it was made from.
struct FreeFormFit {
  std::string side;                   ///< "front" or "back"
  Eigen::Vector2d knot_spacing;       ///< [m]
  std::optional<FitResidual> height;  ///< of a sag grid: at its points
  std::optional<SurfacePower>
      power;  ///< of a progressive surface: largest differences from its closed form within the rim
};

}  // namespace sturm
