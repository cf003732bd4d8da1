#pragma once
#include <Eigen/Core>
#include <memory>
#include <numbers>

#include "pathtrace/cameras/ray_model.h"
#include "pathtrace/sampling/disk.h"
#include "pathtrace/sampling/owen_sobol.h"
#include "pathtrace/sampling/sequence.h"

namespace sturm {

class SharpCells;

/// Points over the pupil that a camera may leave out (pathtrace/plan/).
struct CameraSkips {
  bool zero_pupil = true;                   ///< of a pupil without extent
  std::shared_ptr<const SharpCells> sharp;  ///< of the pixels whose blur cannot be seen; null: of none
};

/// Where the eye is and where it looks; perspective, `camera` gaze (docs/theory.md#32-gaze-models).
struct CameraPose {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< centre of the pupil [m], world
  Eigen::Vector3d look_at{0.0, 0.0, -1.0};  ///< [m], world
  Eigen::Vector3d up{0.0, 1.0, 0.0};
  double vertical_field = 0.6860;  ///< [rad]
  int width = 256, height = 256;   ///< [px]
};

/// Axes right, up and back of the pose as columns: takes the wearer frame to the world's.
Eigen::Matrix3d head_axes(const CameraPose& pose);

/// Pixel pitch in tangent image coordinates [rad].
double pixel_slope(const CameraPose& pose);

/// The same view with `margin_px` more pixels on every side, same pixel pitch; then each pixel divided into
/// oversampling² pixels.
CameraPose widened(const CameraPose& pose, int margin_px, int oversampling);

/// Rays of a block of consecutive samples of one pixel, as structure of arrays.
struct CameraRayBlock {
  static constexpr int size = 16;
  alignas(64) float origin[3][size];
  alignas(64) float direction[3][size];  ///< not normalised: one unit of t is one metre of the camera's distance
  LaunchStatus status[size];
  float weight[size];  ///< of the sample, mean 1; only from cameras that are `weighted`
};

/// The thin-lens eye as a camera. Rays are launched in slope form: origin at the pupil point p, slope = chief slope +
/// s(p). No focal point is formed, so hyperopia and zero power are no special case.
///
/// This is the fast camera, in float: perspective, one gaze, the naked eye, a uniform pupil. ViewCamera has everything
/// else.
class EyeCamera {
 public:
  static constexpr bool weighted = false;

  EyeCamera(const CameraPose& pose, const EyeRays<float>& rays, CameraSkips skips = {});

  int width() const { return width_; }
  int height() const { return height_; }
  const EyeRays<float>& rays() const { return rays_; }
  const Eigen::Vector3f& forward() const { return forward_; }

  /// True where all rays of the pixel go through the pupil's centre although the pupil is wider.
  bool is_sharp(int x, int y) const;

  /// A point of the world on (right, up, forward) of the eye [m].
  Eigen::Vector3f in_eye_frame(const Eigen::Vector3f& world) const {
    const Eigen::Vector3f from = world - position_;
    return {right_.dot(from), up_.dot(from), forward_.dot(from)};
  }

  /// The ray of film place (film_x, film_y) [px] through the pupil point (px, py) [m], as `generate` makes it.
  struct SingleRay {
    Eigen::Vector3f origin, direction;
    LaunchStatus status;
  };
  SingleRay single(float film_x, float film_y, float px, float py) const;

  /// Film place [px] and pupil point [m] of one sample.
  struct SamplePlace {
    float film_x, film_y, px, py;
  };
  SamplePlace place_of(int x, int y, std::uint32_t sample, const PixelSequence& sequence) const;

  /// Chief slopes (x right, y up) [rad] at pixel coordinates, (0, 0) = upper left corner of the image.
  float slope_x(float px) const { return (px - 0.5f * static_cast<float>(width_)) * pixel_slope_; }
  float slope_y(float py) const { return (0.5f * static_cast<float>(height_) - py) * pixel_slope_; }

  /// Fills the block with the rays of samples first_sample … first_sample + size − 1 of pixel (x, y).
  void generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence, CameraRayBlock& block) const;

 private:
  int width_, height_;
  float pixel_slope_;
  Eigen::Vector3f position_, right_, up_, forward_;
  EyeRays<float> rays_;
  CameraSkips skips_;
};

}  // namespace sturm
