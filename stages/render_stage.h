#pragma once
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "conoid/pictures/image_predictor.h"
#include "io/json/json.h"
#include "io/specs/render_spec.h"
#include "pathtrace/film/render.h"
#include "stages/pass_watch.h"
#include "stages/plan/render_plan.h"

namespace sturm {

using ProgressFunction = std::function<void(double fraction)>;  ///< told the fraction done, 0 … 1; may be empty

/// Path traces one view. Accommodation and focus distance come from the eye, relaxed or fixed, for which the model has
/// rays (has_rays).
RenderResult path_trace(const Scene& scene, const CameraPose& pose, const Eye& eye, RayModel model,
                        const RenderSettings& settings, const CameraSkips& skips = {});

/// Path traces what one eye of a render document sees; `sideways_m` is where it is to the right of the camera's
/// position.
RenderResult path_trace_view(const Scene& scene, const RenderSpec& spec, const WornEye& worn, double sideways_m,
                             const RenderSettings& settings, const ViewPlan& plan);

/// How long the two steps of a prediction took.
struct PredictionTimes {
  double sharp_view_seconds = 0.0, spreading_seconds = 0.0;  ///< wall-clock [s]
};

/// A predicted view, and what it was made from.
struct PredictedImage {
  Prediction prediction;          ///< the blurred picture, without the margin
  SharpView source;               ///< that it was spread from
  PredictionTimes times;          ///< of the two steps
  RenderCounters sharp_counters;  ///< of the pinhole rendering
  int margin_px = 0;              ///< that `source` has on each side, in pixels of the picture
};

/// Predicts the same view: one pinhole rendering of `settings.samples_per_pixel` samples per output pixel, spread by
/// the conoid's ellipses.
PredictedImage predict(const Scene& scene, const CameraPose& pose, const Eye& eye, int oversampling,
                       const RenderSettings& settings, const PredictorSettings& spreading = {});

Json counters_json(const RenderCounters& counters);  ///< as they stand in a manifest

/// What `sturm render` writes: the layers, the counters, the seconds of each part, and the notes of the document, its
/// model files and its method. `warning` says what is wrong with the picture as a whole, "" if nothing is; it is one of
/// the notes, too.
struct RenderOutput {
  LayeredImage image;                     ///< linear light; "" is the picture itself
  Json counters;                          ///< for the manifest
  std::vector<std::string> notes;         ///< what is remarkable, in words
  std::string warning;                    ///< "" if nothing is wrong
  std::map<std::string, double> seconds;  ///< wall-clock by part [s]

  /// The picture for people: filtered where the document asks for it, else as rendered.
  const Image& shown() const {
    const auto filtered = image.layers.find("denoised");
    return filtered == image.layers.end() ? image.layers.at("") : filtered->second;
  }
};

/// The plan of work of a document, as a table for people, and for `depth_psf` what is done with each layer of each
/// tile; nothing is lit. Throws InputError.
std::string explain_view(const RenderSpec& spec);

/// The main layer is what was rendered; "denoised", where the document asks for it, is never in its place.
RenderOutput render_view(const RenderSpec& spec, const ProgressFunction& progress, const Preview& preview = {});

}  // namespace sturm
