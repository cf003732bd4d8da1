#pragma once
#include <optional>
#include <variant>

#include "lensmodel/bspline_surface.h"
#include "lensmodel/conic_surface.h"
#include "lensmodel/lens_status.h"
#include "lensmodel/light_ray.h"
#include "lensmodel/sphere_surface.h"
#include "lensmodel/torus_surface.h"

namespace sturm {

/// One side of a spectacle lens, in its surface frame (lensmodel/sag.h). A new kind of surface needs a member `sag`.
using Surface = std::variant<SphereSurface, TorusSurface, ConicSurface, BSplineSurface>;

/// Height and derivatives at (x, y) [m]; none where the surface does not reach.
std::optional<Sag> sag(const Surface& surface, double x, double y);

/// False where a ray certainly misses the surface within `rim_radius` [m] of its axis: a bound from the surface's
/// heights, without looking for the point.
bool may_meet(const Surface& surface, const LightRay& ray, double rim_radius);

/// Where a ray that comes from the eye goes through a surface.
struct SurfaceHit {
  LensStatus status = LensStatus::missed_lens;  ///< unless ok, the rest means nothing
  double distance = 0.0;                        ///< along the ray [m], > 0
  Eigen::Vector3d position;                     ///< [m], surface frame
  Sag sag;                                      ///< at the position: normal and curvature follow from it
};

/// The first outward crossing of the surface within `rim_radius` [m] of its axis. The ray starts on the eye's side, so
/// it has one at a distance > 0 or misses. Spheres in closed form; others by Newton's iteration in a bracket
/// (lensmodel/bracketed_root.h). What is left out: two crossings closer together than 1/16 of the ray's way through the
/// rim's cylinder (grazing) may count as a miss.
SurfaceHit intersect(const Surface& surface, const LightRay& ray, double rim_radius);

}  // namespace sturm
