#include "stages/camera_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/ellipses/image_ellipse.h"
#include "conoid/tracing/footprint.h"
#include "io/files/error.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr int side_px = 288, lamps_across = 3, spacing_px = side_px / lamps_across;
constexpr double lamp_px = 3.0, margin_px = 6.0;
/// Near and far ones beside each other, none in the order of the rows.
constexpr double depths_m[] = {1.0, 0.35, 5.0, 0.5, 2.0, 0.4, 20.0, 0.7, 1.4};

/// A circle is measured as well as an ellipse where it is in the middle of a pixel's grid, and better where it is not.
constexpr double off_grid_px[] = {0.31, -0.17, 0.43, -0.38};

Eigen::Vector2d place_of(int number) {
  const int row = number / lamps_across, column = number % lamps_across;
  return {spacing_px * (column + 0.5) + off_grid_px[number % 4],
          spacing_px * (row + 0.5) + off_grid_px[(number + 1) % 4]};
}

Eigen::Matrix2d angular_at(const Eye& eye, double depth_m) {
  return naked_eye_footprint(eye, depth_m, eye.accommodation_for(0.0)).angular;
}

/// Tangent of the largest semi-axis.
double largest_blur(const Eye& eye) {
  double largest = 0.0;
  for (const double depth : depths_m)
    largest = std::max(largest, Ellipse::image_of_disc(angular_at(eye, depth), eye.pupil_radius_m).semi_major);
  return largest;
}

Image window_of(const Image& picture, int left, int top, int side) {
  Image window(side, side, picture.channels);
  for (int y = 0; y < side; ++y) std::copy_n(picture.at(left, top + y), side * picture.channels, window.at(0, y));
  return window;
}

bool is_dark(const Image& image) {
  return std::none_of(image.pixels.begin(), image.pixels.end(), [](float value) { return value > 0.0f; });
}

}  // namespace

double CameraCheck::pixel_slope() const {
  return 2.0 * std::tan(0.5 * radians_per_degree * vfov_deg) / height;
}

double CameraCheck::lamp_variance_px(const CheckedLamp& lamp) const {
  const double side_px = lamp.side_m / (pixel_slope() * -lamp.position_m.z());
  return side_px * side_px / 12.0;
}

CameraCheck camera_check(const Eye& eye) {
  if (std::holds_alternative<BestAccommodation>(eye.accommodation))
    throw std::invalid_argument("an eye that accommodates differently for each target is no camera");
  if (!(eye.pupil_radius_m > 0.0)) throw std::invalid_argument("a pinhole has no blur");
  CameraCheck check;
  check.width = check.height = side_px;
  check.window_px = 0.5 * spacing_px - 1.0;
  // The largest spot fills its window but for a margin, and the lamp in it.
  const double slope = largest_blur(eye) / (check.window_px - margin_px - lamp_px);
  check.vfov_deg = std::max(1.0, 2.0 * std::atan(0.5 * side_px * slope) / radians_per_degree);
  const double pixel = check.pixel_slope();
  for (int i = 0; i < static_cast<int>(std::size(depths_m)); ++i) {
    CheckedLamp lamp;
    lamp.id = "lamp" + std::to_string(i + 1);
    lamp.centroid_px = place_of(i);
    const double depth = depths_m[i], across = pixel * depth;
    lamp.position_m = {across * (lamp.centroid_px.x() - 0.5 * side_px), across * (0.5 * side_px - lamp.centroid_px.y()),
                       -depth};
    lamp.side_m = lamp_px * across;
    lamp.covariance_px = covariance_of_disc_image(angular_at(eye, depth), eye.pupil_radius_m) / (pixel * pixel);
    check.lamps.push_back(lamp);
  }
  return check;
}

std::vector<std::optional<MeasuredLamp>> measure_lamps(const Image& picture, const CameraCheck& check,
                                                       const std::string& file) {
  if (picture.width != check.width || picture.height != check.height)
    throw InputError(file, "", std::to_string(picture.width) + " × " + std::to_string(picture.height) + " pixels",
                     std::to_string(check.width) + " × " + std::to_string(check.height));
  std::vector<std::optional<MeasuredLamp>> measured;
  for (const CheckedLamp& lamp : check.lamps) {
    const int left = std::max(0, static_cast<int>(std::ceil(lamp.centroid_px.x() - check.window_px))),
              top = std::max(0, static_cast<int>(std::ceil(lamp.centroid_px.y() - check.window_px)));
    const int side = std::min({static_cast<int>(2.0 * check.window_px), check.width - left, check.height - top});
    const Image window = window_of(picture, left, top, side);
    if (is_dark(window)) {
      measured.emplace_back();
      continue;
    }
    SpotImaging imaging;
    imaging.emitter_covariance = check.lamp_variance_px(lamp) * Eigen::Matrix2d::Identity();
    const ImageEllipse spot = measure_image_ellipse(window, nullptr, imaging);
    measured.push_back(MeasuredLamp{spot.centroid_px + Eigen::Vector2d(left, top), spot.covariance});
  }
  return measured;
}

}  // namespace sturm
