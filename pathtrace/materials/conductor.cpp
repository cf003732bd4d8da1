#include "pathtrace/materials/conductor.h"

#include "pathtrace/materials/fresnel.h"
#include "pathtrace/materials/ggx.h"

namespace sturm {

BsdfValue Conductor::evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f&) const {
  if (roughness == 0.0f || !(in.z() > 0.0f) || !(out.z() > 0.0f)) return BsdfValue::none();
  const Ggx facets{roughness * roughness};
  const Eigen::Vector3f h = (out + in).normalized();
  const float scale = facets.density(h) / (4.0f * out.z());
  return {(scale * facets.masking_shadowing(out, in)) * fresnel_conductor(std::min(1.0f, out.dot(h)), eta, kappa),
          scale * facets.masking(out)};
}

BsdfSample Conductor::sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers,
                             const Eigen::Vector3f& albedo) const {
  if (!(out.z() > 0.0f)) return BsdfSample::absorbed();
  if (roughness == 0.0f) return {local::mirrored(out), fresnel_conductor(out.z(), eta, kappa), 1.0f, true};
  const Eigen::Vector3f in =
      local::reflected(out, Ggx{roughness * roughness}.visible_normal(out, numbers.u, numbers.v));
  const BsdfValue at = evaluate(out, in, albedo);
  if (!(at.pdf > 0.0f)) return BsdfSample::absorbed();
  return {in, at.value / at.pdf, at.pdf, false};
}

}  // namespace sturm
