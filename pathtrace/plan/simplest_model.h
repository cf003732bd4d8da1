#pragma once
#include "pathtrace/cameras/ray_model.h"
#include "pathtrace/plan/plan_item.h"

namespace sturm {

/// A ray model that launches the rays of another one with less work, for one eye.
struct SimplestModel {
  RayModel model;
  PlanClaim claim;  ///< same_bits or rounding (or same_bits where it is the model itself)
};

/// Without a cylinder (exactly: both meridians have the same power) power_matrix is thin_lens bit by bit, and
/// sin2_radial, whose power does not depend on the meridian then, to rounding. Without a measured wavefront zernike has
/// the prescription's parabola, so it is power_matrix to rounding. metalstigmatism stays as it is: it counts rays that
/// no other model loses.
SimplestModel simplest_model(RayModel model, const Eye& eye);

}  // namespace sturm
