#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/json/json.h"
#include "lensmodel/ellipse.h"
#include "lensmodel/eye.h"

namespace sturm {

/// A small square lamp that faces the camera, and the spot that it makes in the picture.
struct CheckedLamp {
  std::string id;
  Eigen::Vector3d position_m;     ///< of its middle; the camera stands at the origin, looks along -z, y is up
  double side_m = 0.0;            ///< of the square
  Eigen::Vector2d centroid_px;    ///< of its spot, from the picture's top left corner, y down
  Eigen::Matrix2d covariance_px;  ///< [px²] of its spot on wearer's axes (x right, y up), without lamp and pixel
};

/// A scene with known blur: lamps at several distances and directions before one camera.
struct CameraCheck {
  double vfov_deg = 10.0;
  int width = 0, height = 0;  ///< [px]
  double window_px = 0.0;     ///< half the side of the square about each spot that holds it and no other
  std::vector<CheckedLamp> lamps;

  double pixel_slope() const;  ///< width of a pixel as a tangent

  /// What a lamp's own square adds to the variance of its spot along either axis [px²]; its pixels add 1/12.
  double lamp_variance_px(const CheckedLamp& lamp) const;
};

/// The scene for an eye in `camera` gaze: nine lamps, 0.35 m to 20 m away. What is expected follows from the conoid: a
/// lamp at the depth z, seen through a pupil of radius a, has the second moments a²/4 (I/z + S)², which holds in every
/// direction. The field of view is so large that no spots touch. Throws std::invalid_argument for an eye that does not
/// hold its accommodation, or a pinhole.
CameraCheck camera_check(const Eye& eye);

/// What became of a lamp in a picture.
struct MeasuredLamp {
  Eigen::Vector2d centroid_px;  ///< as expected ones
  Eigen::Matrix2d covariance_px;
};

/// Second moments of each lamp's spot in a linear picture of the check's size, in the order of the lamps, without the
/// lamp's own size and the pixel's; none where the window is dark. Throws InputError about `file` for another size.
std::vector<std::optional<MeasuredLamp>> measure_lamps(const Image& picture, const CameraCheck& check,
                                                       const std::string& file);

/// The sturm.camera_check/1 document; `eye` is the resolved eye that it was made for.
Json to_json(const CameraCheck& check, const Json& eye);

/// Reads it back. Throws InputError.
CameraCheck read_camera_check(const Json& document, const std::string& file);

}  // namespace sturm
