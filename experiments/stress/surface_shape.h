#pragma once
#include "experiments/stress/extended.h"
#include "lensmodel/surface.h"

namespace sturm::stress {

/// How steep and how bent a surface is at a point, from the oracle's description of it: −∇G/G_z is the slope of the
/// height, its derivative along the surface the Hessian.
struct SurfaceShape {
  double gradient = 0.0;        ///< |∇z|
  double hessian = 0.0;         ///< |∇∇z|, Frobenius [1/m]
  double hessian_change = 0.0;  ///< how much that changes along x or y, the larger [1/m²]
};

/// At a point of the surface's sheet, surface frame [m].
SurfaceShape shape_at(const Surface& surface, const Vec3<Extended>& point);

}  // namespace sturm::stress
