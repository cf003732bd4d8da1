#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// A wavefront as [Kakimoto2010] writes it: direction N, principal curvatures κ₁, κ₂ [1/m] (positive = centre ahead, ±∞
/// at a focus) and the principal directions e₁, e₂ across N. The formulas are scalar, so they check the matrix form
/// (conoid/tracing/wavefront.h).
struct FiveVariables {
  Eigen::Vector3d direction;
  double kappa1, kappa2;
  Eigen::Vector3d e1, e2;
};

/// Two principal curvatures of a surface at a point [1/m], positive = centre ahead of the wave, and their directions.
struct PrincipalCurvatures {
  double kappa1, kappa2;
  Eigen::Vector3d e1, e2;
};

/// Of a curvature matrix on two unit vectors across each other, the higher one first.
PrincipalCurvatures principal_curvatures(const Eigen::Matrix2d& curvature, const Eigen::Vector3d& f1,
                                         const Eigen::Vector3d& f2);

/// Eq. 1: κ' = κ/(1 − dκ); through and beyond a focus.
FiveVariables transferred(const FiveVariables& wave, double distance);

/// Eqs. 2–6: refraction from index n₁ into n₂ at a surface of unit normal n, n · N > 0. None at total internal
/// reflection.
std::optional<FiveVariables> refracted(const FiveVariables& wave, const Eigen::Vector3d& normal,
                                       const PrincipalCurvatures& surface, double index_before, double index_behind);

/// Reflection: μ = 1, cos φ' = −cos φ.
FiveVariables reflected(const FiveVariables& wave, const Eigen::Vector3d& normal, const PrincipalCurvatures& surface);

/// Eqs. 7–8: a thin lens of principal powers P₁, P₂ [D] along p₁, p₂ across N, in air.
FiveVariables through_thin_lens(const FiveVariables& wave, const PrincipalCurvatures& power);

}  // namespace sturm
