#pragma once
#include "pathtrace/materials/bsdf.h"

namespace sturm {

/// A clear dielectric coat over a Lambertian base of reflectance `albedo`.
///
/// f = f_coat + (1 − F(out)) (1 − F(in)) / (n² (1 − albedo F_i)) · albedo/π, with F_i the mean reflectance of the coat
/// for diffuse light from inside, so that all orders of reflection between base and coat are summed. Reciprocal. With a
/// smooth coat a white base reflects exactly 1. The base does not see the coat's roughness, so a rough coat is off by
/// the coat's own loss (docs/theory.md#93-estimators).
class Plastic {
 public:
  /// `index` > 1; `roughness` of the coat: 0, or from 0.01 to 1.
  explicit Plastic(float index = 1.5f, float roughness = 0.0f);

  BsdfValue evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) const;
  BsdfSample sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) const;

  float index() const { return index_; }
  float roughness() const { return roughness_; }

  /// F_i.
  float internal_reflectance() const { return internal_; }

 private:
  float coat_probability(const Eigen::Vector3f& out, const Eigen::Vector3f& albedo) const;
  Eigen::Vector3f base(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) const;

  float index_, roughness_, internal_;
};

}  // namespace sturm
