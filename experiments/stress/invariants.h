#pragma once
#include <functional>

#include "conoid/tracing/spectacle_conoid.h"
#include "experiments/stress/check.h"
#include "experiments/stress/error_model.h"
#include "experiments/stress/stress_case.h"
#include "lensmodel/single_vision.h"

namespace sturm::stress {

/// What is checked: `trace_conoid`, or in a test something that is wrong on purpose.
using ConoidTracer =
    std::function<SpectacleConoid(const Spectacles&, const Eigen::Vector3d& gaze, double rotation_center_m)>;

/// A case whose chief ray comes through, with what is known of it.
struct Traced {
  const CaseNumbers& numbers;
  const Eye& eye;
  const Spectacles& lens;
  Eigen::Vector3d gaze;
  const SpectacleConoid& conoid;
  const ErrorBounds& bounds;
  const ExtendedTrace& oracle;
  Eigen::Matrix2d slopes;  ///< S of the case's accommodation
  double vergence_D;
};

/// MᵀJM = J of the 4×4 ray transfer, and AᵀB of the case's bundle symmetric.
void check_symplectic(Outcomes& outcomes, const Traced& traced);

/// The same chain with every transfer in two pieces at `fraction`.
void check_split(Outcomes& outcomes, const Traced& traced, double fraction);

/// Eye and lens turned by `angle_deg` (a B-spline surface by quarters) about the primary line of sight, all lengths
/// times `scale`, and x turned to −x.
void check_turned(Outcomes& outcomes, const Traced& traced, const ConoidTracer& tracer, double angle_deg);
void check_scaled(Outcomes& outcomes, const Traced& traced, const ConoidTracer& tracer, double scale);
void check_mirrored(Outcomes& outcomes, const Traced& traced, const ConoidTracer& tracer);

/// Plus and minus form are one prescription: at the cornea and as a single-vision lens.
void check_transposed(Outcomes& outcomes, const Prescription& rx, const SingleVisionDesign* design);

/// The scalar form of Kakimoto's equations gives the same curvature at the exit point.
void check_five_variables(Outcomes& outcomes, const Traced& traced);

/// X is affine in A; the best accommodation is not beaten by the ends, the middle or its neighbours.
void check_accommodation(Outcomes& outcomes, const Traced& traced);

/// X(d)/d is affine in 1/d up to 1/d = 0, also through the accommodation of `best`.
void check_infinity(Outcomes& outcomes, const Traced& traced);

}  // namespace sturm::stress
