#pragma once
#include <map>
#include <string>

#include "conoid/pictures/sight_field.h"
#include "io/specs/prediction_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// A predicted picture (layer "") with what lies beside it, the counters for the manifest, and the seconds of each
/// part.
struct PredictedView {
  std::map<std::string, Image> layers;
  Json counters;
  std::map<std::string, double> seconds;
  RenderCounters shaded;      ///< of the sharp view
  PredictionCounters spread;  ///< of `layered`
};

/// The conoid's view of what one eye of a document sees.
SightField sight_field(const CameraSpec& camera, const WornEye& worn, double sideways_m);

/// Predicts what one eye sees, `layered` or `multipass`: perspective, gaze `camera` or `foveal`, naked or through
/// spectacles. The conoid says where rays go, the path tracer colours a sharp view and what that does not show:
/// `settings.samples_per_pixel` paths for each output pixel and each unseen place.
PredictedView predict_view(const Scene& scene, const CameraSpec& camera, const WornEye& worn, double sideways_m,
                           const PredictionSpec& prediction, const RenderSettings& settings,
                           const PredictorSettings& spreading = {});

}  // namespace sturm
