#pragma once
#include <map>
#include <string>

#include "conoid/pictures/sight_field.h"
#include "io/specs/prediction_spec.h"
#include "stages/render_stage.h"
#include "stages/see_stage.h"
#include "stages/surfaces_picture.h"

namespace sturm {

/// A predicted picture (layer "") with what lies beside it, the counters for the manifest, and the seconds of each
/// part.
struct PredictedView {
  std::map<std::string, Image> layers;
  Json counters;
  std::map<std::string, double> seconds;
  RenderCounters shaded;      ///< of the sharp view
  PredictionCounters spread;  ///< of `layered`
  std::string explanation;    ///< of `depth_psf`: what was done with each layer of each tile, for people
  SurfacesPicture surfaces;   ///< of `depth_psf`: what was blurred, with what was guessed
};

/// The conoid's view of what one eye of a document sees.
SightField sight_field(const CameraSpec& camera, const WornEye& worn, double sideways_m);

/// Surfaces as an eye sees them, in the picture's own pixels. `pixel_slope` is that of the picture. What is guessed of
/// hidden surfaces is added to them.
SeenPicture see_through_point_spreads(SurfacesPicture& surfaces, const Eye& eye, double pixel_slope,
                                      const PredictionSpec& prediction);

/// Predicts what one eye sees, `layered` or `multipass`: perspective, gaze `camera` or `foveal`, naked or through
/// spectacles; or `depth_psf` (docs/theory.md#87-point-spreads-over-depth-depth_psf), naked and in gaze `camera`, whose
/// point spreads know the whole wavefront. The conoid says where rays go, the path tracer colours a sharp view and what
/// that does not show: `settings.samples_per_pixel` paths for each output pixel and each unseen place.
PredictedView predict_view(const Scene& scene, const CameraSpec& camera, const WornEye& worn, double sideways_m,
                           const PredictionSpec& prediction, const RenderSettings& settings,
                           const PredictorSettings& spreading = {});

}  // namespace sturm
