#pragma once
#include "conoid/tracing/spectacle_conoid.h"
#include "experiments/stress/check.h"
#include "experiments/stress/error_model.h"

namespace sturm::stress {

/// Chief ray, ray transfer, footprint at 1/d and curvature of a conoid that came through, against the oracle's trace.
void check_against_oracle(Outcomes& outcomes, const SpectacleConoid& conoid, const ExtendedTrace& oracle,
                          const ErrorBounds& bounds, const Eigen::Matrix2d& slopes, double vergence_D);

/// What became of the chief ray. Where program and oracle differ within the error bounds of what decides, it is
/// skipped.
void check_status(Outcomes& outcomes, LensStatus status, const Spectacles& lens, const ExtendedTrace& oracle,
                  const ErrorBounds& bounds);

/// A lens that was made with this prism deviates a ray on its axis by it: traced by the oracle, with the lens's wedge.
void check_prism(Outcomes& outcomes, const Spectacles& lens, double prism_cm_per_m, double base_deg);

/// Power at the cornea, by power vectors and the inverse in extended precision; `eye` null where the program refused
/// the prescription.
void check_correction(Outcomes& outcomes, const Prescription& rx, const Eye* eye);

/// Error bound of the power at the cornea [D].
double correction_bound(const Prescription& rx);

}  // namespace sturm::stress
