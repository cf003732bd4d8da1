#include "compare/ellipses/image_ellipse.h"

#include <algorithm>
#include <cmath>

#include "compare/ellipses/bundle_moments.h"
#include "compare/metrics/comparable.h"
#include "io/files/error.h"

namespace sturm {

namespace {

double mean_of_channels(const float* pixel, int channels) {
  double sum = 0.0;
  for (int c = 0; c < channels; ++c) sum += pixel[c];
  return sum / channels;
}

/// Variance of the mean of fully correlated channels: the square of their mean standard deviation.
double variance_of_channel_mean(const float* pixel, int channels) {
  double sum = 0.0;
  for (int c = 0; c < channels; ++c) sum += std::sqrt(std::max(0.0, static_cast<double>(pixel[c])));
  return sum * sum / (static_cast<double>(channels) * channels);
}

Eigen::Vector2d centre_of(int x, int y) {
  return {x + 0.5, y + 0.5};
}

/// Calls visit(pixel centre relative to `origin`, x, y) for every pixel in index order.
template <class Visit>
void for_each_pixel(const Image& image, const Eigen::Vector2d& origin, Visit visit) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) visit(Eigen::Vector2d(centre_of(x, y) - origin), x, y);
}

}  // namespace

ImageEllipse measure_image_ellipse(const Image& image, const Image* variance_of_mean, const SpotImaging& imaging) {
  require_finite(image, "image");
  if (variance_of_mean) require_comparable(image, *variance_of_mean);

  ImageEllipse e;
  double total = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  const Eigen::Vector2d middle(0.5 * image.width, 0.5 * image.height);
  for_each_pixel(image, middle, [&](const Eigen::Vector2d& d, int x, int y) {
    const double w = mean_of_channels(image.at(x, y), image.channels);
    total += w;
    first += w * d;
  });
  if (!(total > 0.0))
    throw InputError("", "", "an image whose pixels sum to " + std::to_string(total),
                     "the image of an emitter (a positive sum)");
  e.centroid_px = middle + first / total;

  Eigen::Vector3d second = Eigen::Vector3d::Zero();  // pixel axes, with everything that is still to be taken off
  for_each_pixel(image, e.centroid_px, [&](const Eigen::Vector2d& d, int x, int y) {
    second +=
        mean_of_channels(image.at(x, y), image.channels) * Eigen::Vector3d(d.x() * d.x(), d.x() * d.y(), d.y() * d.y());
  });
  second /= total;

  const double scale = imaging.pixel_slope, scale2 = scale * scale;
  const Eigen::DiagonalMatrix<double, 2> flip(1.0, -1.0);  // pixel rows run down, the wearer's y runs up
  Eigen::Matrix2d raw;
  raw << second[0], second[1], second[1], second[2];
  e.covariance_px = raw - Eigen::Matrix2d::Identity() / 12.0 - flip * imaging.emitter_covariance * flip / scale2;
  e.covariance = scale2 * (flip * e.covariance_px * flip);
  e.centroid = scale * (flip * (e.centroid_px - imaging.axis_px));
  e.ellipse = Ellipse::of_second_moments(e.covariance);

  if (variance_of_mean) {
    // ∂S_ij/∂w_k = (d_i d_j − S_ij)/Σw; the centroid's own shift drops out because Σ w d = 0.
    Eigen::Matrix3d propagated = Eigen::Matrix3d::Zero();
    Eigen::Vector2d centroid_variance = Eigen::Vector2d::Zero();  // ∂c/∂w_k = d/Σw
    for_each_pixel(image, e.centroid_px, [&](const Eigen::Vector2d& d, int x, int y) {
      const Eigen::Vector3d gradient = (Eigen::Vector3d(d.x() * d.x(), d.x() * d.y(), d.y() * d.y()) - second) / total;
      const double variance = variance_of_channel_mean(variance_of_mean->at(x, y), image.channels);
      propagated += variance * gradient * gradient.transpose();
      centroid_variance += variance * (d / total).cwiseAbs2();
    });
    e.centroid_standard_error = scale * centroid_variance.cwiseSqrt();
    const Eigen::DiagonalMatrix<double, 3> flip_entries(scale2, -scale2, scale2);
    BundleEllipse bundle;  // shares its error formulas
    bundle.covariance = e.covariance;
    bundle.entry_covariance = e.entry_covariance = flip_entries * propagated * flip_entries;
    e.semi_axis_standard_errors = bundle.semi_axis_standard_errors();
  }
  return e;
}

}  // namespace sturm
