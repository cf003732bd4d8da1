#include "conoid/pictures/pixel_rays.h"

#include <cmath>

namespace sturm {

PixelRays::PixelRays(const SightField& field, const Eigen::Vector2d& center)
    : sight(field.at(center)), around(field, center, sight), field_(field) {
  origin_ = sight.origin.cast<float>();
  direction_ = sight.direction.cast<float>();
  origin_by_place_ = around.origin_by_place().cast<float>();
  direction_by_place_ = around.direction_by_place().cast<float>();
}

void PixelRays::bend(double vergence_D) {
  const double a = field_.eye().pupil_radius_m, unseen_px = 0.01;
  if (bent_for_D_ &&
      (!field_.seeks_focus() || a * std::abs(vergence_D - *bent_for_D_) < unseen_px * field_.plane().pixel_slope))
    return;
  bent_for_D_ = vergence_D;
  const Eigen::Matrix2d slopes = field_.slopes(sight, vergence_D);
  origin_by_pupil_ = (a * sight.offsets(slopes)).cast<float>();
  direction_by_pupil_ = (a * sight.directions(slopes)).cast<float>();
}

void PixelRays::append_to(std::vector<float>& numbers) const {
  for (const Eigen::Vector3f& v : {origin_, direction_}) numbers.insert(numbers.end(), v.data(), v.data() + 3);
  for (const auto* map : {&origin_by_place_, &direction_by_place_, &origin_by_pupil_, &direction_by_pupil_})
    for (int row = 0; row < 3; ++row) numbers.insert(numbers.end(), {(*map)(row, 0), (*map)(row, 1)});
}

}  // namespace sturm
