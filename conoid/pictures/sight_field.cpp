#include "conoid/pictures/sight_field.h"

#include <Eigen/LU>
#include <cmath>

#include "conoid/threads/parallel_for.h"
#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/best_accommodation.h"
#include "lensmodel/gaze.h"

namespace sturm {

namespace {

/// Two unit vectors across a direction of any length, as rows.
Eigen::Matrix<double, 2, 3> frame_across(const Eigen::Matrix3d& world_from_head, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d ahead = -world_from_head.col(2), along = direction.normalized();
  const Eigen::Matrix3d turn = smallest_rotation(ahead, along);
  return (turn * world_from_head.leftCols<2>()).transpose();
}

}  // namespace

Sight traced_sight(const PicturePlane& plane, const Eye& eye, const Spectacles* spectacles, const Eigen::Vector2d& q) {
  const Eigen::Vector3d toward(q.x(), q.y(), -1.0), gaze = toward.normalized();
  const Eigen::Matrix3d& world = plane.world_from_head;
  const bool foveal = plane.gaze == Gaze::Foveal;
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  const Eigen::Vector3d pupil =
      foveal ? turned_pupil_center(gaze, eye.rotation_center_m) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  Sight sight;
  if (!spectacles) {
    sight.reaches = true;
    sight.origin = plane.position + world * pupil;
    sight.direction = world * (foveal ? gaze : toward);
    sight.offset_p = sight.slope_s = foveal ? Sight::Map(world * turn.leftCols<2>()) : Sight::Map(world.leftCols<2>());
    sight.offset_s = sight.slope_p = Sight::Map::Zero();
    return sight;
  }
  const SpectacleConoid conoid = trace_conoid_along(*spectacles, {pupil, gaze}, turn.col(0), turn.col(1));
  sight.reaches = conoid.status == LensStatus::ok;
  if (!sight.reaches) return sight;
  const RayTransfer& exit = conoid.exit;
  Sight::Map frame;
  frame << exit.e1, exit.e2;
  frame = world * frame;
  // The turned eye's pupil is across its line of sight; that of an eye that looks straight ahead is seen obliquely.
  const Eigen::Matrix2d across = foveal ? Eigen::Matrix2d(Eigen::Matrix2d::Identity())
                                        : Eigen::Matrix2d(turn.leftCols<2>().transpose().leftCols<2>());
  const double slope_scale = foveal ? 1.0 : 1.0 / toward.norm();
  sight.origin = plane.position + world * conoid.chief_ray.origin;
  sight.direction = world * conoid.chief_ray.direction;
  sight.offset_p = frame * exit.offset_from_offset * across;
  sight.slope_p = frame * exit.slope_from_offset * across;
  sight.offset_s = slope_scale * frame * exit.offset_from_slope * across;
  sight.slope_s = slope_scale * frame * exit.slope_from_slope * across;
  return sight;
}

SightField::SightField(const PicturePlane& plane, const Eye& eye, std::optional<Spectacles> spectacles)
    : plane_(plane), eye_(eye), spectacles_(std::move(spectacles)) {
  if (spectacles_) fill_grid();
}

void SightField::fill_grid() {
  grid_px_ = grid_slope / plane_.pixel_slope;
  columns_ = static_cast<int>(std::ceil(plane_.width / grid_px_)) + 3;
  rows_ = static_cast<int>(std::ceil(plane_.height / grid_px_)) + 3;
  grid_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  parallel_for(0, rows_, [&](int j) {
    for (int i = 0; i < columns_; ++i)
      grid_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)] =
          traced({(i - 1) * grid_px_, (j - 1) * grid_px_});
  });
}

Sight SightField::traced(const Eigen::Vector2d& place) const {
  return traced_sight(plane_, eye_, spectacles_ ? &*spectacles_ : nullptr, plane_.slope(place));
}

std::optional<SightField::Cell> SightField::cell_of(const Eigen::Vector2d& place) const {
  const double column = place.x() / grid_px_ + 1.0, row = place.y() / grid_px_ + 1.0;
  const int i = static_cast<int>(std::floor(column)), j = static_cast<int>(std::floor(row));
  if (i < 0 || j < 0 || i + 1 >= columns_ || j + 1 >= rows_) return std::nullopt;
  const Sight* upper =
      &grid_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)];
  const Sight* lower = upper + columns_;
  if (!(upper[0].reaches && upper[1].reaches && lower[0].reaches && lower[1].reaches)) return std::nullopt;
  const double u = column - i, v = row - j;
  return Cell{{upper, upper + 1, lower, lower + 1}, {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v}};
}

Sight SightField::at(const Eigen::Vector2d& place) const {
  if (!spectacles_) return traced(place);
  const auto cell = cell_of(place);
  if (!cell) return traced(place);
  const auto mean = [&](auto member) {
    auto sum = (cell->weights[0] * (cell->corners[0]->*member)).eval();
    for (int k = 1; k < 4; ++k) sum += cell->weights[k] * (cell->corners[k]->*member);
    return sum;
  };
  Sight sight;
  sight.reaches = true;
  sight.origin = mean(&Sight::origin);
  sight.direction = mean(&Sight::direction);
  sight.offset_p = mean(&Sight::offset_p);
  sight.offset_s = mean(&Sight::offset_s);
  sight.slope_p = mean(&Sight::slope_p);
  sight.slope_s = mean(&Sight::slope_s);
  return sight;
}

std::optional<LightRay> SightField::chief_ray(const Eigen::Vector2d& place) const {
  if (spectacles_) {
    if (const auto cell = cell_of(place)) {
      LightRay ray{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
      for (int k = 0; k < 4; ++k) {
        ray.origin += cell->weights[k] * cell->corners[k]->origin;
        ray.direction += cell->weights[k] * cell->corners[k]->direction;
      }
      return ray;
    }
    const Sight sight = traced(place);
    if (!sight.reaches) return std::nullopt;
    return LightRay{sight.origin, sight.direction};
  }
  const Eigen::Vector2d q = plane_.slope(place);
  const Eigen::Vector3d toward(q.x(), q.y(), -1.0);
  if (plane_.gaze == Gaze::Camera) return LightRay{plane_.position, plane_.world_from_head * toward};
  const Eigen::Vector3d gaze = toward.normalized();
  return LightRay{plane_.position + plane_.world_from_head * turned_pupil_center(gaze, eye_.rotation_center_m),
                  plane_.world_from_head * gaze};
}

std::optional<Eigen::Vector2d> SightField::projected(const Eigen::Vector3d& point) const {
  if (spectacles_) return std::nullopt;
  Eigen::Vector3d p = plane_.world_from_head.transpose() * (point - plane_.position);
  if (plane_.gaze == Gaze::Foveal) p.z() -= eye_.rotation_center_m;
  if (!(p.z() < 0.0)) return std::nullopt;
  const double scale = -1.0 / (p.z() * plane_.pixel_slope);
  return Eigen::Vector2d(0.5 * plane_.width + scale * p.x(), 0.5 * plane_.height - scale * p.y());
}

Eigen::Matrix2d SightField::slopes(const Sight& sight, double vergence_D) const {
  const auto* best = std::get_if<BestAccommodation>(&eye_.accommodation);
  if (!best) return eye_.slope_matrix(eye_.accommodation_for(vergence_D)).matrix();
  if (!spectacles_) return eye_.slope_matrix(eye_.accommodation_for(vergence_D)).matrix();
  const Eigen::Matrix<double, 2, 3> across = frame_across(plane_.world_from_head, sight.direction);
  const Eigen::Matrix2d by_point = across * (vergence_D * sight.offset_p + sight.slope_p),
                        by_slope = across * (vergence_D * sight.offset_s + sight.slope_s);
  return eye_
      .slope_matrix(best_accommodation(by_point + by_slope * eye_.correction.matrix(), by_slope, best->amplitude_D))
      .matrix();
}

SightNeighbourhood::SightNeighbourhood(const SightField& field, const Eigen::Vector2d& place, const Sight& sight)
    : field_(field),
      place_(place),
      sight_(sight),
      across_(frame_across(field.plane().world_from_head, sight.direction)) {
  // Central differences over a pixel; one-sided beside a rim, and without any neighbour as if the picture stood still.
  const LightRay here{sight.origin, sight.direction};
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d step = 0.5 * Eigen::Vector2d::Unit(k);
    const auto ahead = field.chief_ray(place + step), behind = field.chief_ray(place - step);
    const LightRay a = ahead.value_or(here), b = behind.value_or(here);
    const double distance = (ahead ? 0.5 : 0.0) + (behind ? 0.5 : 0.0), scale = distance > 0.0 ? 1.0 / distance : 0.0;
    origin_by_place_.col(k) = scale * (a.origin - b.origin);
    direction_by_place_.col(k) = scale * (a.direction - b.direction);
  }
  across_origin_ = across_ * origin_by_place_;
  across_direction_ = across_ * direction_by_place_;
}

Eigen::Matrix2d SightNeighbourhood::picture_map(const Eigen::Matrix2d& slopes, double vergence_D) const {
  const Eigen::Matrix2d footprint = across_ * (vergence_D * sight_.offsets(slopes) + sight_.directions(slopes));
  return -displacement(vergence_D).inverse() * footprint;
}

std::optional<Eigen::Vector2d> SightNeighbourhood::place_of(const Eigen::Vector3d& point) const {
  if (field_.projects()) return field_.projected(point);
  constexpr int enough = 12;
  constexpr double close_px = 0.02;  // of the step that is taken last: less than a tenth of it is left
  Eigen::Vector2d place = place_;
  LightRay ray{sight_.origin, sight_.direction};
  for (int k = 0; k < enough; ++k) {
    const Eigen::Vector3d to = point - ray.origin;
    const double t = to.dot(ray.direction) / ray.direction.squaredNorm();
    if (!(t > 0.0)) return std::nullopt;
    const Eigen::Vector2d step = displacement(1.0 / t).inverse() * (across_ * (to / t - ray.direction));
    place += step;
    if (step.squaredNorm() < close_px * close_px) return place;
    const auto next = field_.chief_ray(place);
    if (!next) return std::nullopt;
    ray = *next;
  }
  return std::nullopt;
}

}  // namespace sturm
