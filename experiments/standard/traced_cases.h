#pragma once
#include <optional>
#include <string>
#include <vector>

#include "conoid/tracing/footprint.h"
#include "io/specs/experiment/experiment_spec.h"
#include "stages/ray_bundle.h"
#include "stages/render_stage.h"

namespace sturm {

/// The rays of one model in a case.
struct TracedRays {
  RayModel model;
  std::optional<MeasuredBundle> bundle;  ///< none where the model is undefined

  /// Null where nothing was measured.
  const BundleEllipse* ellipse() const { return bundle && bundle->angular ? &*bundle->angular : nullptr; }
};

/// One prescription × distance × pupil with what both predictors say of it: all that an experiment with ellipses
/// measures is a function of these.
struct TracedCase {
  std::string id;            ///< "P172-OS|1 m|6 mm", "…|inf|…"
  std::string prescription;  ///< its id
  Eye eye;
  Footprint footprint;
  std::vector<TracedRays> rays;  ///< by ray model

  /// Null where nothing was measured.
  const BundleEllipse* ellipse_of(RayModel model) const;
};

/// All cases of an experiment, by prescription, then pupil, then distance.
std::vector<TracedCase> traced_cases(const EllipseExperiment& spec, std::uint64_t seed,
                                     const ProgressFunction& progress);

}  // namespace sturm
