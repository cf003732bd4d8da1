#pragma once
#include "experiments/stress/invariants.h"

namespace sturm::stress {

/// What became of one case.
struct CaseRun {
  CaseNumbers numbers;
  Outcomes outcomes;
  std::optional<Eye> eye;  ///< none: the prescription was refused
  std::optional<Spectacles> lens;
  Eigen::Vector3d gaze = Eigen::Vector3d::Zero();
  std::optional<SpectacleConoid> conoid;                   ///< with spectacles
  std::optional<ExtendedTrace> oracle;                     ///< with spectacles
  std::optional<ErrorBounds> bounds;                       ///< with spectacles
  std::optional<Footprint> footprint;                      ///< where the chief ray came through
  bool published_tried = false, published_failed = false;  ///< eq. 11 of the conoid as published
  std::string thrown;                                      ///< what was thrown that should not have been
};

/// Draws a case and runs every check that applies to it. Never throws for what the program does.
CaseRun run_case(std::uint64_t seed, std::uint64_t index, const FreeFormLenses& free_forms,
                 const ConoidTracer& tracer = trace_conoid);

}  // namespace sturm::stress
