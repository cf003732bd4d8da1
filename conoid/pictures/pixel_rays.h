#pragma once
#include <optional>
#include <vector>

#include "conoid/pictures/pupil_passes.h"
#include "conoid/pictures/ray_shading.h"
#include "conoid/pictures/sight_field.h"

namespace sturm {

/// All rays of one pixel: origin and direction, and how they move with the place in the pixel and with the point of the
/// unit disc.
struct PixelRays {
  Sight sight;
  SightNeighbourhood around;

  PixelRays(const SightField& field, const Eigen::Vector2d& center);

  /// For an eye that looks at this vergence. An eye that accommodates stays as it is while its blur is off by less than
  /// 1/100 of a pixel.
  void bend(double vergence_D);

  SeenRay chief(const Eigen::Vector2f& film) const {
    const Eigen::Vector2f d = film - Eigen::Vector2f(0.5f, 0.5f);
    return {origin_ + origin_by_place_ * d, direction_ + direction_by_place_ * d};
  }
  SeenRay through(const PupilPass& pass) const {
    const SeenRay c = chief(pass.film);
    return {c.origin + origin_by_pupil_ * pass.pupil, c.direction + direction_by_pupil_ * pass.pupil};
  }

  /// Appends origin, direction, and what they change by the place in the pixel [1/px] and by the point of the unit
  /// disc: origin and direction by place, origin and direction by pupil (3 × 2, row by row): 30 numbers.
  void append_to(std::vector<float>& numbers) const;

 private:
  const SightField& field_;
  std::optional<double> bent_for_D_;
  Eigen::Vector3f origin_, direction_;
  Eigen::Matrix<float, 3, 2> origin_by_place_, direction_by_place_, origin_by_pupil_, direction_by_pupil_;
};

}  // namespace sturm
