#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/specs/camera_spec.h"
#include "io/specs/eye_spec.h"
#include "io/specs/pupil_sampling_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "io/specs/scene_spec.h"

namespace sturm {

/// One way to see: an eye and the ray model that traces it.
struct SamplingConfiguration {
  std::string id, note;
  Eye eye;  ///< accommodation relaxed or fixed
  RayModel ray_model = RayModel::power_matrix;
};

/// The same view of one scene: every configuration × sampling × sampler, against the uniform disc.
struct SamplingStudySpec {
  std::string scene_name;  ///< as given
  SceneSpec scene;
  CameraSpec camera;
  std::vector<SamplingConfiguration> configurations;  ///< ids are unique
  std::vector<PupilSamplingSpec> samplings;
  std::vector<Sequence> samplers;
  std::uint64_t samples_per_pixel = 0;  ///< of each replicate
  int replicates = 0;                   ///< independently seeded pictures, ≥ 3
  int max_bounces = 16;
};

/// Reads a validated "sampling_study" section. Throws InputError.
SamplingStudySpec read_sampling_study(const Json& value, const Source& where);

}  // namespace sturm
