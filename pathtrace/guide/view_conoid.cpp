#include "pathtrace/guide/view_conoid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pathtrace/sampling/across.h"

namespace sturm {

namespace {

constexpr int least_spacing = 16, most_cells = 64, rays_of_fit = 16;

/// By how much a ray passes beside the place that a conoid says, in offset [m] and direction.
struct Deviation {
  Eigen::Vector2d pupil_point, offset, direction;
};

/// Of two rings of rays, at the pupil's rim and at half its radius; those that are lost are missing.
std::vector<Deviation> deviations(const ViewConoid& conoid, const GeneralCamera& camera,
                                  const GeneralCamera::Sight& sight, const LightRay& chief, const PupilSlopes& slopes) {
  const Eigen::Matrix<double, 2, 3> across = axes_across(chief);
  std::vector<Deviation> result;
  for (int k = 0; k < rays_of_fit; ++k) {
    const double angle = 4.0 * std::numbers::pi * k / rays_of_fit,
                 radius = (k % 2 ? 1.0 : 0.5) * camera.rays().pupil_radius();
    const Eigen::Vector2d p = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                          s = slopes.constant + slopes.matrix * p;
    const auto ray = camera.leaving(sight, {p.x(), p.y(), s.x(), s.y(), LaunchStatus::ok});
    if (!ray) continue;
    const GeneralCamera::Bundle& b = conoid.bundle;
    result.push_back(
        {p, offset_across(across, chief, *ray) - conoid.offset - b.offset_by_point * p - b.offset_by_slope * s,
         across * ray->direction / ray->direction.dot(chief.direction) - conoid.direction - b.direction_by_point * p -
             b.direction_by_slope * s});
  }
  return result;
}

std::optional<ViewConoid> conoid_at(const GeneralCamera& camera, const PupilSlopes& slopes, double film_x,
                                    double film_y) {
  const GeneralCamera::Sight sight = camera.sight_at(film_x, film_y);
  const auto chief = camera.leaving(sight, {0.0, 0.0, 0.0, 0.0, LaunchStatus::ok});
  if (!chief) return std::nullopt;
  ViewConoid conoid{camera.differences(sight, *chief)};
  const std::vector<Deviation> tangent = deviations(conoid, camera, sight, *chief, slopes);
  if (tangent.size() == rays_of_fit) {  // rings evenly filled: the least-squares map is a matter of two means
    const double n = rays_of_fit,
                 square = n * 0.5 * 0.625 * std::pow(camera.rays().pupil_radius(), 2);  // of either component of p
    for (const Deviation& d : tangent) {
      conoid.offset += d.offset / n;
      conoid.direction += d.direction / n;
      conoid.bundle.offset_by_point += d.offset * d.pupil_point.transpose() / square;
      conoid.bundle.direction_by_point += d.direction * d.pupil_point.transpose() / square;
    }
  }
  for (const Deviation& d : deviations(conoid, camera, sight, *chief, slopes)) {
    conoid.offset_residual_m = std::max(conoid.offset_residual_m, d.offset.norm());
    conoid.direction_residual = std::max(conoid.direction_residual, d.direction.norm());
  }
  return conoid;
}

void add(ViewConoid& sum, double weight, const ViewConoid& part) {
  sum.bundle.offset_by_point += weight * part.bundle.offset_by_point;
  sum.bundle.direction_by_point += weight * part.bundle.direction_by_point;
  sum.bundle.offset_by_slope += weight * part.bundle.offset_by_slope;
  sum.bundle.direction_by_slope += weight * part.bundle.direction_by_slope;
  sum.offset += weight * part.offset;
  sum.direction += weight * part.direction;
  sum.offset_residual_m += weight * part.offset_residual_m;
  sum.direction_residual += weight * part.direction_residual;
}

ViewConoid nothing() {
  ViewConoid conoid;
  conoid.bundle.offset_by_point.setZero();
  conoid.bundle.direction_by_slope.setZero();
  return conoid;
}

}  // namespace

ViewConoidField::ViewConoidField(const GeneralCamera& camera, const PupilSlopes& slopes) {
  const int longer = std::max(camera.width(), camera.height());
  spacing_ = std::max(least_spacing, (longer + most_cells - 1) / most_cells);
  across_ = (camera.width() + spacing_ - 1) / spacing_ + 1;
  down_ = (camera.height() + spacing_ - 1) / spacing_ + 1;
  corners_.reserve(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_));
  for (int j = 0; j < down_; ++j)
    for (int i = 0; i < across_; ++i) corners_.push_back(conoid_at(camera, slopes, i * spacing_, j * spacing_));
}

std::optional<ViewConoid> ViewConoidField::at(double film_x, double film_y) const {
  const double x = film_x / spacing_, y = film_y / spacing_;
  const int i = std::clamp(static_cast<int>(x), 0, across_ - 2), j = std::clamp(static_cast<int>(y), 0, down_ - 2);
  const double u = std::clamp(x - i, 0.0, 1.0), v = std::clamp(y - j, 0.0, 1.0);
  ViewConoid sum = nothing();
  double total = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const int right = corner % 2, low = corner / 2;
    const double weight = (right ? u : 1.0 - u) * (low ? v : 1.0 - v);
    const auto& conoid = corners_[static_cast<std::size_t>((j + low) * across_ + i + right)];
    if (!conoid || !(weight > 0.0)) continue;
    add(sum, weight, *conoid);
    total += weight;
  }
  if (!(total > 0.0)) return std::nullopt;
  ViewConoid mean = nothing();
  add(mean, 1.0 / total, sum);
  return mean;
}

}  // namespace sturm
