#pragma once
#include <Eigen/Core>
#include <cmath>
#include <optional>

namespace sturm {

/// Snell's law for a unit direction at a surface with the unit normal `normal` on the far side (direction · normal >
/// 0), in vector form: μN + γn with μ = n₁/n₂, γ = cos φ' − μ cos φ. None where the light is totally reflected.
/// [Kakimoto2010] eqs. 2–4
inline std::optional<Eigen::Vector3d> refracted(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal,
                                                double index_before, double index_behind) {
  const double mu = index_before / index_behind, cosine = direction.dot(normal);
  const double square = 1.0 - mu * mu * (1.0 - cosine * cosine);
  if (!(square > 0.0)) return std::nullopt;
  return (mu * direction + (std::sqrt(square) - mu * cosine) * normal).normalized();
}

}  // namespace sturm
