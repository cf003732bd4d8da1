#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "io/json/json.h"
#include "lensmodel/words.h"

namespace sturm {

enum class Projection { Perspective, Equirectangular };

inline constexpr Words<Projection, 2> projection_words{
    {{Projection::Perspective, "perspective"}, {Projection::Equirectangular, "equirectangular"}}};

/// docs/theory.md#32-gaze-models: one gaze for the whole picture, or the eye turns to each of its points.
enum class Gaze { Camera, Foveal };

inline constexpr Words<Gaze, 2> gaze_words{{{Gaze::Camera, "camera"}, {Gaze::Foveal, "foveal"}}};

/// In primary gaze the pupil's centre is `position` and the line of sight meets `look_at`; in a stereo pair `position`
/// is midway between the pupils, whose lines of sight are parallel.
struct CameraSpec {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m]
  Eigen::Vector3d look_at{0.0, 0.0, -1.0};  ///< [m], not at `position`
  Eigen::Vector3d up{0.0, 1.0, 0.0};        ///< any length; not parallel to the line of sight
  double vfov = 0.0;          ///< full vertical field of view [rad], in (0, π); equirectangular: not used
  int width = 0, height = 0;  ///< [px], of one eye's picture
  Projection projection = Projection::Perspective;
  Gaze gaze = Gaze::Camera;
  std::optional<double> interpupillary_distance_m;  ///< of a stereo pair
};

/// Where something is and where it looks.
struct LineOfSight {
  Eigen::Vector3d position, look_at, up;  ///< [m]; `up` of any length
};

/// Reads position_m, look_at_m and up of an object. Throws InputError unless they give a direction that is not parallel
/// to `up`.
LineOfSight read_line_of_sight(const Json& value, const Source& where);

/// Reads a "camera" object. Throws InputError.
CameraSpec read_camera(const Json& value, const Source& where);

/// Throws InputError unless the camera is a single eye in perspective and `camera` gaze; `what` is what needs that.
void require_plain_camera(const Json& value, const Source& where, const std::string& what);

}  // namespace sturm
