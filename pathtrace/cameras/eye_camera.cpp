#include "pathtrace/cameras/eye_camera.h"

#include <algorithm>
#include <utility>

#include "pathtrace/cameras/sharp_cells.h"
#include "pathtrace/sampling/disk.h"

namespace sturm {

static_assert(Camera<EyeCamera>);

EyeCamera::EyeCamera(const CameraPose& pose, const EyeRays<float>& rays, CameraSkips skips)
    : width_(pose.width),
      height_(pose.height),
      pixel_slope_(static_cast<float>(pixel_slope(pose))),
      rays_(rays),
      skips_(std::move(skips)) {
  const Eigen::Matrix3f axes = head_axes(pose).cast<float>();
  position_ = pose.position.cast<float>();
  right_ = axes.col(0);
  up_ = axes.col(1);
  forward_ = -axes.col(2);
}

EyeCamera::Pixel EyeCamera::pixel(int x, int y) const {
  const bool without_extent = rays_.pupil_radius() == 0.0f && skips_.zero_pupil;
  return {x, y, without_extent || (skips_.sharp && skips_.sharp->at(x, y))};
}

EyeCamera::SamplePlace EyeCamera::place_of(const Pixel& pixel, std::uint32_t sample,
                                           const PixelSequence& sequence) const {
  const FilmPlace film = film_place(pixel, sequence.pair(sample, dimension::film));
  if (pixel.pinhole) return {film, 0.0f, 0.0f};
  const auto lens = sequence.pair(sample, dimension::lens);
  const auto disk = concentric_disk(unit_float(lens.x), unit_float(lens.y));
  return {film, rays_.pupil_radius() * disk.x, rays_.pupil_radius() * disk.y};
}

CameraRay EyeCamera::single(const Pixel& pixel, const SamplePlace& at) const {
  const PupilRay<float> ray =
      pixel.pinhole ? PupilRay<float>{0.0f, 0.0f, 0.0f, 0.0f, LaunchStatus::ok} : rays_.through(at.px, at.py);
  const float cx = slope_x(at.film.x()) + ray.sx, cy = slope_y(at.film.y()) + ray.sy;
  return {position_ + ray.px * right_ + ray.py * up_, forward_ + cx * right_ + cy * up_, ray.status};
}

/// The rays of a block as they leave the pupil.
struct EyeCamera::PupilRays {
  static constexpr int size = CameraRayBlock::size;
  alignas(64) float px[size], py[size], sx[size], sy[size];
  LaunchStatus status[size];
};

/// Through points all over the pupil.
void EyeCamera::launch(std::uint32_t first_sample, const PixelSequence& sequence, PupilRays& rays) const {
  constexpr int size = PupilRays::size;
  const auto lens = sequence.pairs<size>(first_sample, dimension::lens);
  const float radius = rays_.pupil_radius();
  for (int i = 0; i < size; ++i) {
    const auto disk = concentric_disk(unit_float(lens.x[i]), unit_float(lens.y[i]));
    rays.px[i] = radius * disk.x;
    rays.py[i] = radius * disk.y;
  }
  for_model(rays_.model(), [&](auto model) {
    for (int i = 0; i < size; ++i) {
      const auto ray = rays_.through_as<model>(rays.px[i], rays.py[i]);
      rays.sx[i] = ray.sx;
      rays.sy[i] = ray.sy;
      rays.status[i] = ray.status;
    }
  });
}

void EyeCamera::generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence,
                         CameraRayBlock& block) const {
  constexpr int size = CameraRayBlock::size;
  PupilRays rays;
  if (pixel(x, y).pinhole)
    for (int i = 0; i < size; ++i) {
      rays.px[i] = rays.py[i] = rays.sx[i] = rays.sy[i] = 0.0f;
      rays.status[i] = LaunchStatus::ok;
    }
  else
    launch(first_sample, sequence, rays);

  const auto film = sequence.pairs<size>(first_sample, dimension::film);
  const float fx = static_cast<float>(x), fy = static_cast<float>(y);
  for (int i = 0; i < size; ++i) {
    const float cx = slope_x(fx + unit_float(film.x[i])) + rays.sx[i];
    const float cy = slope_y(fy + unit_float(film.y[i])) + rays.sy[i];
    for (int k = 0; k < 3; ++k) {
      block.origin[k][i] = position_[k] + rays.px[i] * right_[k] + rays.py[i] * up_[k];
      block.direction[k][i] = forward_[k] + cx * right_[k] + cy * up_[k];
    }
  }
  std::copy(rays.status, rays.status + size, block.status);
}

}  // namespace sturm
