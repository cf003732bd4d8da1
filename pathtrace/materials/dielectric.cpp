#include "pathtrace/materials/dielectric.h"

#include "pathtrace/materials/fresnel.h"
#include "pathtrace/materials/ggx.h"

namespace sturm {

namespace {

/// `out` above the surface; eta = far index / near index.
BsdfValue rough_value(const Ggx& facets, const Eigen::Vector3f& out, const Eigen::Vector3f& in, float eta) {
  if (in.z() > 0.0f) {
    const Eigen::Vector3f h = (out + in).normalized();
    const float reflectance = fresnel_dielectric(std::min(1.0f, out.dot(h)), eta).reflectance;
    const float scale = reflectance * facets.density(h) / (4.0f * out.z());
    return {Eigen::Vector3f::Constant(scale * facets.masking_shadowing(out, in)), scale * facets.masking(out)};
  }
  // The facet that refracts `out` into `in`: h ∥ −(n_out·out + n_in·in), turned to the front.
  Eigen::Vector3f h = out + eta * in;
  if (!(h.squaredNorm() > 0.0f)) return BsdfValue::none();
  h.normalize();
  if (h.z() < 0.0f) h = -h;
  const float near = out.dot(h), far = -in.dot(h);
  if (!(near > 0.0f) || !(far > 0.0f)) return BsdfValue::none();
  const DielectricFresnel fresnel = fresnel_dielectric(std::min(1.0f, near), eta);
  const float root = near - eta * far;
  if (!(root * root > 0.0f)) return BsdfValue::none();
  // (1 − F) D |out·h| |in·h| / (cos θ_out (out·h + η in·h)²): eq. 21 with the cosine, the radiance factor η⁻² against
  // the Jacobian's η².
  const float common = (1.0f - fresnel.reflectance) * facets.density(h) * near * far / (out.z() * root * root);
  const float g_out = facets.masking(out), g_in = facets.masking(-in);
  return {Eigen::Vector3f::Constant(common * g_out * g_in), common * eta * eta * g_out};
}

}  // namespace

BsdfValue Dielectric::evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f&) const {
  if (roughness == 0.0f || out.z() == 0.0f || in.z() == 0.0f) return BsdfValue::none();
  const bool outside = out.z() > 0.0f;
  const Ggx facets{roughness * roughness};
  return outside ? rough_value(facets, out, in, index) : rough_value(facets, -out, -in, 1.0f / index);
}

BsdfSample Dielectric::sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers,
                              const Eigen::Vector3f& albedo) const {
  if (out.z() == 0.0f) return BsdfSample::absorbed();
  const bool outside = out.z() > 0.0f;
  const float side = outside ? 1.0f : -1.0f, eta = outside ? index : 1.0f / index;
  const Eigen::Vector3f above = side * out;
  const Eigen::Vector3f h = roughness == 0.0f ? Eigen::Vector3f(0.0f, 0.0f, 1.0f)
                                              : Ggx{roughness * roughness}.visible_normal(above, numbers.u, numbers.v);
  const float near = above.dot(h);
  if (!(near > 0.0f)) return BsdfSample::absorbed();
  const DielectricFresnel fresnel = fresnel_dielectric(std::min(1.0f, near), eta);
  const bool reflects = numbers.lobe < fresnel.reflectance;
  const Eigen::Vector3f in_above =
      reflects ? local::reflected(above, h) : local::refracted(above, h, fresnel.cosine_in, eta).normalized();
  if (roughness == 0.0f) {
    if (reflects) return {side * in_above, Eigen::Vector3f::Ones(), fresnel.reflectance, true};
    return {side * in_above, Eigen::Vector3f::Constant(1.0f / (eta * eta)), 1.0f - fresnel.reflectance, true,
            eta * eta};
  }
  if (reflects != (in_above.z() > 0.0f))
    return BsdfSample::absorbed();  // leaves on the wrong side: would meet another facet
  const BsdfValue at = evaluate(out, side * in_above, albedo);
  if (!(at.pdf > 0.0f)) return BsdfSample::absorbed();
  return {side * in_above, at.value / at.pdf, at.pdf, false, reflects ? 1.0f : eta * eta};
}

}  // namespace sturm
