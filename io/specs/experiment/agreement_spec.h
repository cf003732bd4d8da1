#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/specs/camera_spec.h"
#include "io/specs/prediction_spec.h"
#include "io/specs/scene_spec.h"
#include "io/specs/worn_eye_spec.h"

namespace sturm {

/// One view that is path traced (power_matrix) and predicted in several ways: any gaze, naked or through spectacles;
/// perspective, one eye.
struct AgreementCase {
  std::string id, note;
  std::string scene_name;  ///< as given
  SceneSpec scene;
  CameraSpec camera;
  WornEye worn;
  std::vector<PredictionSpec> predictions;
  std::uint64_t samples_per_pixel = 0;         ///< of each path-traced replicate
  std::uint64_t sharp_samples_per_pixel = 16;  ///< of each prediction's sharp view
  int replicates = 2;                          ///< independently seeded pictures of each kind, ≥ 2
  int max_bounces = 16;
  std::vector<std::string> input_files;  ///< absolute paths of the files that it names
};

/// Reads an experiment's list "agreement". Throws InputError, also where a prediction does not know the gaze or the
/// spectacles.
std::vector<AgreementCase> read_agreement(const Json& list, const Source& where);

}  // namespace sturm
