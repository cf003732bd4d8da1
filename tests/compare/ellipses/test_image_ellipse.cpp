#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>

#include "compare/ellipses/image_ellipse.h"
#include "io/files/error.h"

namespace sturm {
namespace {

/// Image of a Gaussian spot of covariance `cov_px` (pixel axes, y down) about `centre`: the exact integral over each
/// pixel is replaced by 16 × 16 midpoints, whose own error (h²/24 of the curvature) is far below the tolerances here
/// and accounted for by its variance 1/12·(1 − 1/16²).
Image gaussian_spot(int width, int height, const Eigen::Vector2d& centre, const Eigen::Matrix2d& cov_px,
                    int channels = 1) {
  Image image(width, height, channels);
  const Eigen::Matrix2d inverse = cov_px.inverse();
  constexpr int sub = 16;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0.0;
      for (int i = 0; i < sub * sub; ++i) {
        const Eigen::Vector2d d = Eigen::Vector2d(x + (i % sub + 0.5) / sub, y + (i / sub + 0.5) / sub) - centre;
        sum += std::exp(-0.5 * d.dot(inverse * d));
      }
      for (int c = 0; c < channels; ++c) image.at(x, y)[c] = static_cast<float>((c + 1) * sum);
    }
  return image;
}

Eigen::Matrix2d slanted() {
  Eigen::Matrix2d m;
  m << 9.0, 4.0, 4.0, 6.0;
  return m;
}

constexpr double midpoint_rule = 1.0 / 12.0 / 256.0;  // variance that 16 midpoints per pixel lack
constexpr double float_pixels = 1e-5;                 // 2^-24 per pixel, weighted by squared distances

TEST(ImageEllipse, RecoversCentroidAndCovarianceWithoutThePixelBox) {
  const Eigen::Vector2d centre(30.3, 20.8);
  const ImageEllipse e = measure_image_ellipse(gaussian_spot(64, 48, centre, slanted()), nullptr, {});
  EXPECT_NEAR((e.centroid_px - centre).norm(), 0.0, float_pixels);
  EXPECT_NEAR((e.covariance_px - slanted()).norm(), 0.0, 2.0 * midpoint_rule + 1e-4);
  EXPECT_FALSE(e.semi_axis_standard_errors);
}

TEST(ImageEllipse, RowsRunDownAndTheWearersYRunsUp) {
  SpotImaging imaging;
  imaging.pixel_slope = 0.01;
  imaging.axis_px = {32.0, 24.0};
  // pixel covariance +4: right goes with down, so in the wearer frame the ellipse falls to the right
  const ImageEllipse e = measure_image_ellipse(gaussian_spot(64, 48, {30.0, 20.0}, slanted()), nullptr, imaging);
  EXPECT_NEAR(e.centroid.x(), -0.02, 1e-6);
  EXPECT_NEAR(e.centroid.y(), +0.04, 1e-6);  // four rows above the axis
  EXPECT_NEAR(e.covariance(0, 1), -4e-4, 1e-7);
  EXPECT_LT(*e.ellipse.orientation_deg, -30.0);
  EXPECT_GT(*e.ellipse.orientation_deg, -45.0);
}

TEST(ImageEllipse, TakesOffTheEmitter) {
  SpotImaging imaging;
  imaging.pixel_slope = 0.5;
  imaging.emitter_covariance << 0.25, 0.1, 0.1, 0.5;  // wearer frame: in pixels 4·[[.25, −.1], [−.1, .5]]
  Eigen::Matrix2d emitter_px;
  emitter_px << 1.0, -0.4, -0.4, 2.0;
  const ImageEllipse e =
      measure_image_ellipse(gaussian_spot(64, 64, {32, 32}, slanted() + emitter_px), nullptr, imaging);
  EXPECT_NEAR((e.covariance_px - slanted()).norm(), 0.0, 2.0 * midpoint_rule + 1e-4);
}

TEST(ImageEllipse, OneFullPixelIsAPoint) {
  Image image(5, 5, 1);
  *image.at(3, 1) = 2.0f;
  const ImageEllipse e = measure_image_ellipse(image, nullptr, {});
  EXPECT_EQ(e.centroid_px, Eigen::Vector2d(3.5, 1.5));
  EXPECT_NEAR(e.covariance_px(0, 0), -1.0 / 12.0,
              1e-15);  // a spot that the pixels cannot resolve: reported, not hidden
  EXPECT_EQ(e.ellipse.semi_major, 0.0);
}

TEST(ImageEllipse, DoesNotDependOnTheNumberOfChannels) {
  const ImageEllipse one = measure_image_ellipse(gaussian_spot(40, 40, {20, 20}, slanted(), 1), nullptr, {});
  const ImageEllipse three = measure_image_ellipse(gaussian_spot(40, 40, {20, 20}, slanted(), 3), nullptr, {});
  EXPECT_NEAR((one.covariance_px - three.covariance_px).norm(), 0.0, float_pixels);
}

TEST(ImageEllipse, PropagatedErrorIsTheScatterOfNoisyImages) {
  const Image clean = gaussian_spot(32, 32, {16, 16}, slanted());
  Image variance(32, 32, 1);
  for (std::size_t i = 0; i < variance.pixels.size(); ++i) variance.pixels[i] = 0.5f * clean.pixels[i] + 0.01f;
  const ImageEllipse e = measure_image_ellipse(clean, &variance, {});
  std::mt19937_64 generator(3);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5; };
  constexpr int images = 400;
  Eigen::Matrix2d mean = Eigen::Matrix2d::Zero(), squares = Eigen::Matrix2d::Zero();
  Eigen::Vector2d centroid_squares = Eigen::Vector2d::Zero();
  for (int i = 0; i < images; ++i) {
    Image noisy = clean;
    for (std::size_t k = 0; k < noisy.pixels.size(); ++k)
      noisy.pixels[k] += static_cast<float>(uniform() * std::sqrt(12.0 * variance.pixels[k]));
    const ImageEllipse measured = measure_image_ellipse(noisy, nullptr, {});
    const Eigen::Matrix2d d = measured.covariance - e.covariance;
    centroid_squares += (measured.centroid - e.centroid).cwiseAbs2() / images;
    mean += d / images;
    squares += d.cwiseAbs2() / images;
  }
  const Eigen::Matrix2d scatter = (squares - mean.cwiseAbs2()).cwiseSqrt();
  const Eigen::Vector3d se = e.entry_covariance->diagonal().cwiseSqrt();
  // a standard deviation from 400 values: 1/√800 = 3.5 %; 4σ
  EXPECT_NEAR(scatter(0, 0) / se[0], 1.0, 0.14);
  EXPECT_NEAR(scatter(0, 1) / se[1], 1.0, 0.14);
  EXPECT_NEAR(scatter(1, 1) / se[2], 1.0, 0.14);
  const Eigen::Vector2d centroid_scatter = centroid_squares.cwiseSqrt();
  EXPECT_NEAR(centroid_scatter.x() / e.centroid_standard_error->x(), 1.0, 0.14);
  EXPECT_NEAR(centroid_scatter.y() / e.centroid_standard_error->y(), 1.0, 0.14);
}

TEST(ImageEllipse, RefusesWhatIsNoSpot) {
  EXPECT_THROW(measure_image_ellipse(Image(), nullptr, {}), InputError);
  EXPECT_THROW(measure_image_ellipse(Image(8, 8, 3), nullptr, {}), InputError);  // black
  Image broken = gaussian_spot(8, 8, {4, 4}, slanted());
  const Image small(7, 8, 1);
  EXPECT_THROW(measure_image_ellipse(broken, &small, {}), InputError);
  broken.pixels[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(measure_image_ellipse(broken, nullptr, {}), InputError);
}

}  // namespace
}  // namespace sturm
