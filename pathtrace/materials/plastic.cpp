#include "pathtrace/materials/plastic.h"

#include "pathtrace/materials/diffuse.h"
#include "pathtrace/materials/fresnel.h"
#include "pathtrace/materials/ggx.h"

namespace sturm {

namespace {

/// Mean reflectance for diffuse light from outside, 2 ∫ F(μ) μ dμ; midpoints in μ², where the integrand is smooth but
/// for a root at 0.
double diffuse_reflectance(float index) {
  constexpr int steps = 4096;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double square = (i + 0.5) / steps;
    sum += static_cast<double>(fresnel_dielectric(static_cast<float>(std::sqrt(square)), index).reflectance);
  }
  return sum / steps;
}

}  // namespace

Plastic::Plastic(float index, float roughness)
    : index_(index),
      roughness_(roughness),
      // What enters diffuse light through the coat leaves it the same way: (1 − F_i) n² = 1 − F_e.
      internal_(static_cast<float>(1.0 - (1.0 - diffuse_reflectance(index)) /
                                             (static_cast<double>(index) * static_cast<double>(index)))) {}

/// Probability of sampling the coat: its share of what the two layers reflect, as far as it is known before sampling.
float Plastic::coat_probability(const Eigen::Vector3f& out, const Eigen::Vector3f& albedo) const {
  const float coat = fresnel_dielectric(out.z(), index_).reflectance, below = (1.0f - coat) * albedo.maxCoeff();
  return below > 0.0f ? coat / (coat + below) : 1.0f;
}

/// The base's f · cos θ_in.
Eigen::Vector3f Plastic::base(const Eigen::Vector3f& out, const Eigen::Vector3f& in,
                              const Eigen::Vector3f& albedo) const {
  const float through = (1.0f - fresnel_dielectric(out.z(), index_).reflectance) *
                        (1.0f - fresnel_dielectric(in.z(), index_).reflectance);
  const Eigen::Array3f orders = 1.0f - internal_ * albedo.array();
  return (albedo.array() / orders * (through * in.z() / (local::pi * index_ * index_))).matrix();
}

BsdfValue Plastic::evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in,
                            const Eigen::Vector3f& albedo) const {
  if (!(out.z() > 0.0f) || !(in.z() > 0.0f)) return BsdfValue::none();
  const float coat = coat_probability(out, albedo);
  BsdfValue sum{base(out, in, albedo), (1.0f - coat) * in.z() / local::pi};
  if (roughness_ == 0.0f) return sum;
  const Ggx facets{roughness_ * roughness_};
  const Eigen::Vector3f h = (out + in).normalized();
  const float scale = facets.density(h) / (4.0f * out.z());
  const float reflectance = fresnel_dielectric(std::min(1.0f, out.dot(h)), index_).reflectance;
  sum.value.array() += scale * facets.masking_shadowing(out, in) * reflectance;
  sum.pdf += coat * scale * facets.masking(out);
  return sum;
}

BsdfSample Plastic::sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers,
                           const Eigen::Vector3f& albedo) const {
  if (!(out.z() > 0.0f)) return BsdfSample::absorbed();
  const float coat = coat_probability(out, albedo);
  Eigen::Vector3f in;
  if (numbers.lobe < coat) {
    if (roughness_ == 0.0f) {
      const float reflectance = fresnel_dielectric(out.z(), index_).reflectance;
      return {local::mirrored(out), Eigen::Vector3f::Constant(reflectance / coat), coat, true};
    }
    in = local::reflected(out, Ggx{roughness_ * roughness_}.visible_normal(out, numbers.u, numbers.v));
  } else {
    in = Diffuse::sample(out, numbers, albedo).in;
  }
  const BsdfValue at = evaluate(out, in, albedo);
  if (!(at.pdf > 0.0f)) return BsdfSample::absorbed();
  return {in, at.value / at.pdf, at.pdf, false};
}

}  // namespace sturm
