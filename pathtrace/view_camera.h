#pragma once
#include <functional>
#include <optional>

#include "io/camera_spec.h"
#include "lensmodel/spectacles.h"
#include "pathtrace/camera.h"
#include "pathtrace/pupil_sampler.h"

namespace sturm {

/// Everything that a view may ask for besides a pose and an eye.
struct ViewOptions {
  Projection projection = Projection::Perspective;
  Gaze gaze = Gaze::Camera;
  PupilSampler pupil;
  std::optional<Spectacles> spectacles;  ///< fixed to the head
  double sideways_m = 0.0;  ///< of the eye from the pose's position, to the right; equirectangular: it goes round with the head

  /// Distance [m] of what a ray (world) meets first, ∞ for nothing. Needed by an eye that accommodates to what it looks at.
  std::function<double(const LightRay&)> distance_along;
};

/// The eye as a camera in double precision (physics.md §3–5): through spectacles, with any spread of points over the pupil, over the whole
/// sphere, or with an eye that turns to each point of the picture.
///
/// - Gaze `camera`, perspective: as EyeCamera; spectacles stand fixed before the pupil with the line of sight of primary gaze as axis.
/// - Gaze `camera`, equirectangular: the head turns, about the pupil's centre, first by the longitude, then by the latitude, and looks
///   straight ahead; spectacles turn with it. Longitude grows to the right from −180° to 180°, latitude falls from 90° to −90°.
/// - Gaze `foveal`, perspective: each point of the picture is the fovea's view along the direction that belongs to it, seen from the eye's
///   centre of rotation; the eye turns there by Listing's law behind the fixed spectacles, and accommodates to what it meets there.
///
/// A unit of t is a metre of planar distance in gaze `camera` with perspective, otherwise of distance along the ray; it counts from the
/// pupil's plane, with spectacles from the front surface.
class ViewCamera {
 public:
  static constexpr bool weighted = true;

  /// Throws std::invalid_argument for a foveal equirectangular view, and for an eye that accommodates best without `distance_along`.
  ViewCamera(const CameraPose& pose, const Eye& eye, RayModel model, ViewOptions options);

  int width() const { return pose_.width; }
  int height() const { return pose_.height; }

  /// Fills the block with the rays of samples first_sample … first_sample + size − 1 of pixel (x, y).
  void generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence, CameraRayBlock& block) const;

 private:
  struct Sight;
  struct Bundle;

  Eigen::Vector3d in_world(const Sight& sight, const Eigen::Vector3d& point) const;
  Sight sight_at(double px, double py) const;
  Bundle bundle_about(const Sight& sight) const;
  double accommodation_change(const Sight& sight, const Bundle& bundle) const;
  bool launch(const Sight& sight, const PupilRay<double>& ray, LightRay& out, LaunchStatus& status) const;

  CameraPose pose_;
  Eye eye_;
  EyeRays<double> rays_;
  ViewOptions options_;
  bool seeks_focus_;
  double pixel_slope_;
  Eigen::Matrix3d world_from_head_;
};

}  // namespace sturm
