#include "pathtrace/cameras/camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "pathtrace/cameras/sharp_cells.h"

namespace sturm {

Eigen::Matrix3d head_axes(const CameraPose& pose) {
  const Eigen::Vector3d forward = (pose.look_at - pose.position).normalized(),
                        right = forward.cross(pose.up).normalized();
  Eigen::Matrix3d axes;
  axes << right, right.cross(forward), -forward;
  return axes;
}

double pixel_slope(const CameraPose& pose) {
  return 2.0 * std::tan(0.5 * pose.vertical_field) / pose.height;
}

CameraPose widened(const CameraPose& pose, int margin_px, int oversampling) {
  CameraPose wide = pose;
  wide.width = (pose.width + 2 * margin_px) * oversampling;
  wide.height = (pose.height + 2 * margin_px) * oversampling;
  wide.vertical_field = 2.0 * std::atan(0.5 * pixel_slope(pose) * (pose.height + 2 * margin_px));
  return wide;
}

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

bool EyeCamera::is_sharp(int x, int y) const {
  return skips_.sharp && skips_.sharp->at(x, y);
}

void EyeCamera::generate(int x, int y, std::uint32_t first_sample, const PixelSequence& sequence,
                         CameraRayBlock& block) const {
  constexpr int size = CameraRayBlock::size;
  alignas(64) std::uint32_t film_x[size], film_y[size], lens_x[size], lens_y[size];
  const owen_sobol::Keys film_key = sequence.keys(dimension::film), lens_key = sequence.keys(dimension::lens);
  const bool pinhole = (rays_.pupil_radius() == 0.0f && skips_.zero_pupil) || is_sharp(x, y);
  if (sequence.kind() == Sequence::Sobol) {
    for (int i = 0; i < size; ++i) {
      const auto film = owen_sobol::pair(first_sample + static_cast<std::uint32_t>(i), film_key);
      film_x[i] = film.x;
      film_y[i] = film.y;
    }
    if (!pinhole) {
      for (int i = 0; i < size; ++i) {
        const auto lens = owen_sobol::pair(first_sample + static_cast<std::uint32_t>(i), lens_key);
        lens_x[i] = lens.x;
        lens_y[i] = lens.y;
      }
    }
  } else if (sequence.kind() == Sequence::Halton) {
    for (int i = 0; i < size; ++i) {
      const auto film = sequence.pair(first_sample + static_cast<std::uint32_t>(i), dimension::film);
      film_x[i] = film.x;
      film_y[i] = film.y;
      if (pinhole) continue;
      const auto lens = sequence.pair(first_sample + static_cast<std::uint32_t>(i), dimension::lens);
      lens_x[i] = lens.x;
      lens_y[i] = lens.y;
    }
  } else {
    for (int i = 0; i < size; ++i) {
      const auto film = PixelSequence::independent(first_sample + static_cast<std::uint32_t>(i), film_key.order);
      film_x[i] = film.x;
      film_y[i] = film.y;
      if (pinhole) continue;
      const auto lens = PixelSequence::independent(first_sample + static_cast<std::uint32_t>(i), lens_key.order);
      lens_x[i] = lens.x;
      lens_y[i] = lens.y;
    }
  }

  alignas(64) float px[size], py[size], sx[size], sy[size];
  if (pinhole) {
    for (int i = 0; i < size; ++i) {
      px[i] = py[i] = sx[i] = sy[i] = 0.0f;
      block.status[i] = LaunchStatus::ok;
    }
  } else {
    const float radius = rays_.pupil_radius();
    for (int i = 0; i < size; ++i) {
      const auto disk = concentric_disk(unit_float(lens_x[i]), unit_float(lens_y[i]));
      px[i] = radius * disk.x;
      py[i] = radius * disk.y;
    }
    for_model(rays_.model(), [&](auto model) {
      for (int i = 0; i < size; ++i) {
        const auto ray = rays_.through_as<model>(px[i], py[i]);
        sx[i] = ray.sx;
        sy[i] = ray.sy;
        block.status[i] = ray.status;
      }
    });
  }

  const float fx = static_cast<float>(x), fy = static_cast<float>(y);
  for (int i = 0; i < size; ++i) {
    const float cx = slope_x(fx + unit_float(film_x[i])) + sx[i];
    const float cy = slope_y(fy + unit_float(film_y[i])) + sy[i];
    for (int k = 0; k < 3; ++k) {
      block.origin[k][i] = position_[k] + px[i] * right_[k] + py[i] * up_[k];
      block.direction[k][i] = forward_[k] + cx * right_[k] + cy * up_[k];
    }
  }
}

EyeCamera::SamplePlace EyeCamera::place_of(int x, int y, std::uint32_t sample, const PixelSequence& sequence) const {
  const auto film = sequence.pair(sample, dimension::film), lens = sequence.pair(sample, dimension::lens);
  const auto disk = concentric_disk(unit_float(lens.x), unit_float(lens.y));
  const float radius = rays_.pupil_radius();
  return {static_cast<float>(x) + unit_float(film.x), static_cast<float>(y) + unit_float(film.y), radius * disk.x,
          radius * disk.y};
}

EyeCamera::SingleRay EyeCamera::single(float film_x, float film_y, float px, float py) const {
  const auto ray = rays_.through(px, py);
  const float cx = slope_x(film_x) + ray.sx, cy = slope_y(film_y) + ray.sy;
  return {position_ + ray.px * right_ + ray.py * up_, forward_ + cx * right_ + cy * up_, ray.status};
}

}  // namespace sturm
