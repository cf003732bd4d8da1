#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/specs/camera_spec.h"
#include "io/specs/experiment/picture_measures.h"
#include "io/specs/prediction_spec.h"
#include "io/specs/scene_spec.h"
#include "io/specs/worn_eye_spec.h"

namespace sturm {

/// One view that is path traced by ray models and predicted: perspective, one eye, accommodation relaxed or fixed.
struct PictureExperiment {
  PictureMeasures measures = PictureMeasures::Metrics;
  std::string id, note;
  std::string scene_name;  ///< as given
  SceneSpec scene;
  CameraSpec camera;
  std::string prescription;  ///< id of the experiment's prescription that the eye has; "" of an eye of its own
  WornEye worn;
  std::vector<RayModel> ray_models;
  std::vector<PredictionSpec> predictions;
  bool layer_sum = false;                      ///< beside depth_psf by rays: the plain sum of its blurred layers
  std::uint64_t samples_per_pixel = 0;         ///< of each path-traced replicate
  std::uint64_t sharp_samples_per_pixel = 16;  ///< of each prediction's sharp view
  int replicates = 2;                          ///< independently seeded pictures of each kind, ≥ 2
  bool guide_emitters = false;                 ///< as in RenderSpec, of the path-traced pictures
  int max_bounces = 16;                        ///< of the path-traced pictures and the sharp views
  std::vector<std::string> input_files;        ///< absolute paths of the files that it names
};

/// The prescription of an id of the experiment. Throws InputError where there is none.
using PrescriptionNamed = std::function<const Prescription&(const Json& id, const Source& where)>;

/// Reads an experiment's lists "images" (naked eyes in `camera` gaze, predicted by ellipses) and "agreement" (path
/// traced with power_matrix or zernike), in this order. Throws InputError, also where ids of a list are not unique and
/// where a prediction does not know the gaze or the spectacles.
std::vector<PictureExperiment> read_pictures(const Json& document, const Source& root,
                                             const PrescriptionNamed& prescription);

}  // namespace sturm
