#include "compare/psf/point_spread.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/metrics/comparable.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"

namespace sturm {

Eigen::Vector2d PointSpread::centroid() const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i];
  return sum;
}

Eigen::Matrix2d PointSpread::covariance() const {
  const Eigen::Vector2d middle = centroid();
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d d = points[i] - middle;
    sum += weights[i] * d * d.transpose();
  }
  return sum - cell_arcmin * cell_arcmin / 12.0 * Eigen::Matrix2d::Identity();
}

PointSpread PointSpread::centred() const {
  PointSpread result = *this;
  const Eigen::Vector2d middle = centroid();
  for (Eigen::Vector2d& p : result.points) p -= middle;
  return result;
}

PointSpread spread_of_rays(std::span<const Eigen::Vector2d> angles_rad, bool independent) {
  const std::vector<double> ones(angles_rad.size(), 1.0);
  PointSpread spread = spread_of_rays(angles_rad, ones);
  if (!independent) spread.independent_rays = 0.0;
  return spread;
}

PointSpread spread_of_rays(std::span<const Eigen::Vector2d> angles_rad, std::span<const double> weights) {
  double total = 0.0, squares = 0.0;
  for (const double w : weights) total += w, squares += w * w;
  if (angles_rad.size() != weights.size() || !(total > 0.0))
    throw std::invalid_argument("spread_of_rays: needs one weight per ray, with a positive sum");
  PointSpread spread;
  for (const Eigen::Vector2d& angle : angles_rad) spread.points.push_back(arcminutes_per_radian * angle);
  for (const double w : weights) spread.weights.push_back(w / total);
  spread.independent_rays = total * total / squares;
  return spread;
}

PointSpread spread_of_image(const Image& image, double pixel_arcmin) {
  require_finite(image, "image");
  PointSpread spread;
  spread.cell_arcmin = pixel_arcmin;
  double total = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      double weight = 0.0;
      for (int c = 0; c < image.channels; ++c) weight += image.at(x, y)[c] / static_cast<double>(image.channels);
      if (weight == 0.0) continue;
      spread.points.push_back(pixel_arcmin *
                              Eigen::Vector2d(x + 0.5 - 0.5 * image.width, 0.5 * image.height - y - 0.5));
      spread.weights.push_back(weight);
      total += weight;
    }
  if (!(total > 0.0))
    throw InputError("", "", "an image whose pixels sum to " + plain_number(total, 9), "the image of an emitter");
  for (double& w : spread.weights) w /= total;
  return spread;
}

PointSpread spread_of_ellipse(const Eigen::Matrix2d& map, double radius_m, int count) {
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  PointSpread spread;
  for (int i = 0; i < count; ++i) {
    const double r = radius_m * std::sqrt((i + 0.5) / count), angle = golden_angle * i;
    spread.points.push_back(arcminutes_per_radian * (map * Eigen::Vector2d(r * std::cos(angle), r * std::sin(angle))));
  }
  spread.weights.assign(static_cast<std::size_t>(count), 1.0 / count);
  return spread;
}

}  // namespace sturm
