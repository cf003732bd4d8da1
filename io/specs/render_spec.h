#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/specs/camera_spec.h"
#include "io/specs/denoise_spec.h"
#include "io/specs/prediction_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "io/specs/scene_spec.h"
#include "io/specs/skip_spec.h"
#include "io/specs/stop_spec.h"
#include "io/specs/worn_eye_spec.h"

namespace sturm {
/// Light is followed to the pupil, or sharp light is spread as the conoid predicts.
enum class RenderMethod { PathTrace, Predict };

/// A validated document of format sturm.render/1.
struct RenderSpec {
  SceneSpec scene;              ///< models, materials, lights and surroundings
  CameraSpec camera;            ///< where the eye stands, its field of view, gaze and pixels
  WornEye eye;                  ///< the right or only one; accommodation relaxed or fixed unless the gaze is foveal
  std::optional<WornEye> left;  ///< of a stereo pair
  RenderMethod method = RenderMethod::PathTrace;  ///< how the picture is made
  std::optional<RayModel> ray_model;              ///< of the path tracer; none for a prediction
  std::uint64_t samples_per_pixel = 64;  ///< of the path tracer, or of the prediction's sharp view (per output pixel)
  int max_bounces = 16;                  ///< reflections of the longest path
  bool guide_emitters = true;            ///< of the path tracer, where the pupil's spread has a density
  StopSpec stop;                         ///< of the path tracer, like the next two
  std::optional<AdaptiveSpec> adaptive;  ///< none: all pixels have the same number of samples
  std::optional<DenoiseSpec> denoise;    ///< none: no filtered layer
  Sequence sampler = Sequence::Sobol;    ///< what samples are drawn from
  PupilSamplingSpec sampling;            ///< how rays are spread over the pupil
  SkipSpec skip;                         ///< what the picture may do without
  double sharp_below_px = 0.02;          ///< blur up to which `skip.sharp_pixels` applies (path tracing only)
  PredictionSpec prediction;             ///< for RenderMethod::Predict
  std::uint64_t seed = 1;                ///< of all random numbers
  std::vector<std::string> notes;        ///< for the manifest
  std::vector<std::string> input_files;  ///< absolute paths of further files that were named
  std::shared_ptr<const Json> resolved;  ///< the document with every default spelt out; eye files are put in place,
                                         ///< paths of lenses, scenes and models stay as given
};

/// True where both eyes of a stereo pair are alike and wear the same.
bool eyes_are_alike(const RenderSpec& spec);

/// Validates and reads a render document; `file` names it in errors and is where relative paths start. Throws
/// InputError.
RenderSpec read_render_spec(const Json& document, const std::string& file);

}  // namespace sturm
