#include "pathtrace/plan/simplest_model.h"

namespace sturm {

SimplestModel simplest_model(RayModel model, const Eye& eye) {
  const PowerMatrix& power = eye.correction;
  const bool isotropic = power.xx() == power.yy() && power.xy() == 0.0;
  const bool parabola = model == RayModel::zernike && !eye.wavefront;
  if (isotropic && model == RayModel::power_matrix) return {RayModel::thin_lens, PlanClaim::same_bits};
  if (isotropic && (model == RayModel::sin2_radial || parabola)) return {RayModel::thin_lens, PlanClaim::rounding};
  if (parabola) return {RayModel::power_matrix, PlanClaim::rounding};
  return {model, PlanClaim::same_bits};
}

}  // namespace sturm
