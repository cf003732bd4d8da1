#pragma once
#include <functional>
#include <optional>

#include "io/specs/camera_spec.h"
#include "lensmodel/spectacles.h"
#include "pathtrace/cameras/camera_concept.h"
#include "pathtrace/cameras/camera_pose.h"
#include "pathtrace/sampling/pupil_sampler.h"

namespace sturm {

/// Everything that a view may ask for besides a pose and an eye.
struct ViewOptions {
  Projection projection = Projection::Perspective;
  Gaze gaze = Gaze::Camera;
  PupilSampler pupil;
  std::optional<Spectacles> spectacles;  ///< fixed to the head
  double sideways_m =
      0.0;  ///< of the eye from the pose's position, to the right; equirectangular: it goes round with the head

  /// Distance [m] of what a ray (world) meets first, ∞ for nothing. Needed by an eye that accommodates to what it looks
  /// at.
  std::function<double(const LightRay&)> distance_along;
};

/// The eye as a camera in double precision (docs/theory.md#91-camera-and-pixel): through spectacles, with any spread of
/// points over the pupil, over the whole sphere, or with an eye that turns to each point of the picture.
///
/// - Gaze `camera`, perspective: as EyeCamera; spectacles stand fixed before the pupil with the line of sight of
/// primary gaze as axis.
/// - Gaze `camera`, equirectangular: the head turns, about the pupil's centre, first by the longitude, then by the
/// latitude, and looks
///   straight ahead; spectacles turn with it. Longitude grows to the right from −180° to 180°, latitude falls from 90°
///   to −90°.
/// - Gaze `foveal`, perspective: each point of the picture is the fovea's view along the direction that belongs to it,
/// seen from the eye's
///   centre of rotation; the eye turns there by Listing's law behind the fixed spectacles, and accommodates to what it
///   meets there.
///
/// A unit of t is a metre of planar distance in gaze `camera` with perspective, otherwise of distance along the ray; it
/// counts from the pupil's plane, with spectacles from the front surface.
class GeneralCamera {
 public:
  static constexpr bool weighted = true;

  /// Throws std::invalid_argument for a foveal equirectangular view, and for an eye that accommodates best without
  /// `distance_along`.
  GeneralCamera(const CameraPose& pose, const Eye& eye, RayModel model, ViewOptions options);

  /// How the eye stands for one point of the picture.
  struct Sight {
    Eigen::Matrix3d world_from_head;
    Eigen::Vector3d pupil_center;  ///< [m], head
    Eigen::Matrix3d turn;          ///< head from pupil
    Eigen::Vector2d slope;         ///< of the chief ray, pupil frame

    LightRay in_head(const PupilRay<double>& ray) const {
      return {pupil_center + turn * Eigen::Vector3d(ray.px, ray.py, 0.0),
              (turn * Eigen::Vector3d(ray.sx + slope.x(), ray.sy + slope.y(), -1.0)).normalized()};
    }
  };

  /// First derivatives of the rays that leave the eye and its spectacles with respect to the pupil point and to the
  /// slope: offset across the chief ray [m] and difference of direction, on the axes that the smallest rotation of −z
  /// to the chief ray makes of x and y (head).
  struct Bundle {
    Eigen::Matrix2d offset_by_point = Eigen::Matrix2d::Identity(), direction_by_point = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d offset_by_slope = Eigen::Matrix2d::Zero(), direction_by_slope = Eigen::Matrix2d::Identity();
  };

  /// A point of the picture with all that its rays share.
  struct Place {
    Sight sight;
    double accommodation_change = 0.0;  ///< of an eye that accommodates to what it looks at [D]
  };

  /// What all samples of a pixel share: of an eye that seeks focus its bundle; of others it says nothing.
  struct Pixel {
    int x, y;
    Bundle focus_bundle;
  };

  using FilmPlace = Eigen::Vector2d;  ///< [px]

  /// Film place [px] and point of the unit disc of one sample.
  struct SamplePlace {
    FilmPlace film;
    WeightedPoint pupil;
  };

  int width() const { return pose_.width; }
  int height() const { return pose_.height; }
  const EyeRays<double>& rays() const { return rays_; }
  const Eye& eye() const { return eye_; }
  const Eigen::Vector3d& position() const { return pose_.position; }  ///< [m], world
  const PupilSampler& pupil() const { return options_.pupil; }
  bool seeks_focus() const { return seeks_focus_; }  ///< accommodates to what it looks at
  double pixel_angle() const;                        ///< of one pixel, the largest of the picture [rad]

  Pixel pixel(int x, int y) const;
  FilmPlace film_place(const Pixel& pixel, owen_sobol::Pair numbers) const {
    return {pixel.x + unit_double(numbers.x), pixel.y + unit_double(numbers.y)};
  }
  SamplePlace place_of(const Pixel& pixel, std::uint32_t sample, const PixelSequence& sequence) const;
  Eigen::Vector2f pupil_point(const SamplePlace& at) const {
    return (rays_.pupil_radius() * at.pupil.point).cast<float>();
  }
  CameraRay single(const Pixel& pixel, const SamplePlace& at) const;
  void generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence, CameraRayBlock& block) const;

  Place place(const Pixel& pixel, const FilmPlace& film) const;

  /// The ray of a place through the pupil point (px, py) [m].
  CameraRay through(const Place& place, double px, double py) const;

  Sight sight_at(double film_x, double film_y) const;

  /// A ray from the pupil as it leaves the eye or the spectacles, head frame; none where it is lost.
  std::optional<LightRay> leaving(const Sight& sight, const PupilRay<double>& ray) const;

  /// By central differences of real rays about `chief`, the sight's own: exact to the square of the steps, 0.1 mm and
  /// 0.1 mrad. Rays that are lost leave their entries as they are without spectacles.
  Bundle differences(const Sight& sight, const LightRay& chief) const;

  /// A point of the world [m] in the head frame of a sight.
  Eigen::Vector3d in_head(const Sight& sight, const Eigen::Vector3d& world) const;

 private:
  Eigen::Vector3d in_world(const Sight& sight, const Eigen::Vector3d& point) const;
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
