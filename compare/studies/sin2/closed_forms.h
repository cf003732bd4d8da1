#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// Covariance [rad²] at a target of vergence 1/d [D] of the `metalstigmatism` pattern of a uniform pupil of radius `a`
/// [m] (docs/theory.md#51-metalstigmatism-its-pole-and-the-emmetrope): slope −P/(1 + d_f P)·p with P(φ) the power of
/// the symmetric matrix `f` [D] along the meridian φ. With P = M + H cos 2ψ about the principal axes and q(ψ) = 1/d −
/// 1/d_f + 1/(d_f (A + B cos 2ψ)), A = 1 + d_f M, B = d_f H, the variances are a²/4·(⟨q²⟩ ± ⟨q² cos 2ψ⟩), which are
/// rational functions of √(A² − B²). None where |B| ≥ |A|: the pole lies within the pupil, and q² has no integral.
std::optional<Eigen::Matrix2d> metalstigmatism_covariance(const Eigen::Matrix2d& f, double target_vergence_D,
                                                          double focus_distance_m, double a);

/// Whether the pole 1 + d_f P(φ) = 0 lies on a meridian of the eye with power `f` [D]; never for a focus at infinity.
bool has_pole(const Eigen::Matrix2d& f, double focus_distance_m);

}  // namespace sturm
