#pragma once
#include "io/json/json.h"

namespace sturm {

/// Switches of the plan of work: what a view may leave out where its scene, eye and lens do not need it. All on unless
/// stated; off, the work is done all the same, so that it can be measured what it costs. The names are those of the
/// keys.
struct SkipSpec {
  bool scalar_power = true;    ///< without a cylinder: a ray model that bends rays by one number
  bool zero_pupil = true;      ///< a pupil without extent: no points over the pupil
  bool sharp_pixels = true;    ///< where the blur cannot exceed `sharp_below_px`: no points over the pupil
  bool refraction = true;      ///< naked eye, perspective, one gaze, uniform pupil: the camera that knows no spectacles
  bool surface_models = true;  ///< Lambert everywhere: a path tracer's loop without specular and transparent models
  bool shading_frames =
      true;  ///< flat Lambert surfaces with nothing around: a loop without shading normals and surroundings
  bool environment_light = true;  ///< surroundings of one colour: not sampled as a light; black ones: none
  bool unseen_emitters = true;    ///< emitters that face no surface: left out of the choice of a light
  bool converged_tiles = true;    ///< adaptive sampling: no samples for tiles that are good enough
  bool same_views = true;         ///< views that coincide: rendered once
  bool sharp_spots = true;        ///< prediction: pixels whose ellipse is smaller than a part of a pixel are copied
};

/// Reads an object with every key of SkipSpec, e.g. the resolved `method.skip` of a render document.
SkipSpec read_skips(const Json& resolved);

}  // namespace sturm
