#pragma once
#include <optional>
#include <vector>

#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/cameras/general_camera.h"

namespace sturm::testing {

constexpr int view_size = 32;  ///< of the pictures [px]

/// A camera of view_size² pixels at the origin, ahead; the field in rad.
CameraPose view_pose(double field = 0.12);

/// With a pupil of 6 mm.
Eye view_eye(const Prescription& rx, const Accommodation& accommodation = RelaxedAccommodation{});

/// What a camera that is not an eye alone may look through.
struct ViewCase {
  const char* name;
  Eye eye;
  RayModel model = RayModel::power_matrix;
  std::optional<Spectacles> spectacles = {};
  Gaze gaze = Gaze::Camera;
  PupilSamplingSpec sampling = {};
  double apodization = 0.0;
  double light_radius = 0.05e-3;   ///< of the picture of a small light
  double largest_residual = 0.05;  ///< of the conoid, per distance and pupil radius [D]

  ViewOptions options(const Scene* scene = nullptr) const {
    ViewOptions o;
    o.gaze = gaze;
    o.spectacles = spectacles;
    o.pupil = PupilSampler(sampling, apodization);
    if (scene) o.distance_along = [scene](const LightRay& ray) { return distance_along(*scene, ray); };
    return o;
  }
};

const ViewCase& toric();
const ViewCase& progressive();
const ViewCase& focal_line();
const ViewCase& rim_cut();
const ViewCase& folded();
const ViewCase& weighted_polar();
const ViewCase& raw_polar();

/// Of these kinds and others, those whose means are compared.
std::vector<ViewCase> view_cases();

}  // namespace sturm::testing
