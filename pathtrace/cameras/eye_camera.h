#pragma once
#include <Eigen/Core>
#include <memory>

#include "pathtrace/cameras/camera_concept.h"
#include "pathtrace/cameras/camera_pose.h"

namespace sturm {

class SharpCells;

/// Points over the pupil that a camera may leave out (pathtrace/plan/).
struct CameraSkips {
  bool zero_pupil = true;                   ///< of a pupil without extent
  std::shared_ptr<const SharpCells> sharp;  ///< of the pixels whose blur cannot be seen; null: of none
};

/// The thin-lens eye as a camera. Rays are launched in slope form: origin at the pupil point p, slope = chief slope +
/// s(p). No focal point is formed, so hyperopia and zero power are no special case.
///
/// This is the fast camera, in float: perspective, one gaze, the naked eye, a uniform pupil. GeneralCamera has
/// everything else.
class EyeCamera {
 public:
  static constexpr bool weighted = false;

  EyeCamera(const CameraPose& pose, const EyeRays<float>& rays, CameraSkips skips = {});

  /// What all samples of a pixel share.
  struct Pixel {
    int x, y;
    bool pinhole;  ///< all rays go straight through the pupil's centre
  };

  using FilmPlace = Eigen::Vector2f;  ///< [px]

  /// Film place [px] and pupil point [m] of one sample.
  struct SamplePlace {
    FilmPlace film;
    float px, py;
  };

  int width() const { return width_; }
  int height() const { return height_; }
  const EyeRays<float>& rays() const { return rays_; }
  const Eigen::Vector3f& forward() const { return forward_; }

  /// A point of the world on (right, up, forward) of the eye [m].
  Eigen::Vector3f in_eye_frame(const Eigen::Vector3f& world) const {
    const Eigen::Vector3f from = world - position_;
    return {right_.dot(from), up_.dot(from), forward_.dot(from)};
  }

  /// Chief slopes (x right, y up) [rad] at a film place.
  float slope_x(float film_x) const { return (film_x - 0.5f * static_cast<float>(width_)) * pixel_slope_; }
  float slope_y(float film_y) const { return (0.5f * static_cast<float>(height_) - film_y) * pixel_slope_; }

  Pixel pixel(int x, int y) const;
  FilmPlace film_place(const Pixel& pixel, owen_sobol::Pair numbers) const {
    return {static_cast<float>(pixel.x) + unit_float(numbers.x), static_cast<float>(pixel.y) + unit_float(numbers.y)};
  }
  SamplePlace place_of(const Pixel& pixel, std::uint32_t sample, const PixelSequence& sequence) const;
  Eigen::Vector2f pupil_point(const SamplePlace& at) const { return {at.px, at.py}; }
  CameraRay single(const Pixel& pixel, const SamplePlace& at) const;
  void generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence, CameraRayBlock& block) const;

 private:
  struct PupilRays;
  void launch(std::uint32_t first_sample, const PixelSequence& sequence, PupilRays& rays) const;

  int width_, height_;
  float pixel_slope_;
  Eigen::Vector3f position_, right_, up_, forward_;
  EyeRays<float> rays_;
  CameraSkips skips_;
};

}  // namespace sturm
