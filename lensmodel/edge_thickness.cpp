#include "lensmodel/edge_thickness.h"

#include <cmath>
#include <numbers>

namespace sturm {

namespace {

constexpr int meridians = 720;  // over a whole turn: free-form surfaces and prisms look the same only after that

/// Height of the back surface in the lens's frame: where the parallel to the lens's axis meets it, turned or not.
std::optional<double> back_height(const Spectacles& lens, double x, double y) {
  if (!lens.mounting.has_wedge()) {
    const auto there = sag(lens.back, x, y);
    return there ? std::optional(there->value) : std::nullopt;
  }
  const Eigen::Matrix3d turn = lens.mounting.lens_from_back().transpose();
  const double start = lens.diameter_m;  // on the eye's side of any back surface within its rim
  const SurfaceHit hit = intersect(
      lens.back, {turn * Eigen::Vector3d(x, y, start), turn * Eigen::Vector3d(0.0, 0.0, -1.0)}, 0.75 * lens.diameter_m);
  return hit.status == LensStatus::ok ? std::optional(start - hit.distance) : std::nullopt;
}

/// None where a surface does not reach.
std::optional<double> thickness_at(const Spectacles& lens, double radius, double angle) {
  const double x = radius * std::cos(angle), y = radius * std::sin(angle);
  const auto back = back_height(lens, x, y);
  const auto front = sag(lens.front, x, y);
  if (!back || !front) return std::nullopt;
  return lens.center_thickness_m + *back - front->value;  // z > 0 lies towards the eye
}

/// Least value of f in [low, high], where it has one minimum, by golden section to the rounding of its argument.
template <class Function>
double least(Function&& f, double low, double high) {
  constexpr double golden = std::numbers::phi - 1.0;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < 40; ++i) {
    if (at_left < at_right) {
      high = right, right = left, at_right = at_left;
      at_left = f(left = high - golden * (high - low));
    } else {
      low = left, left = right, at_left = at_right;
      at_right = f(right = low + golden * (high - low));
    }
  }
  return std::fmin(at_left, at_right);
}

}  // namespace

std::optional<ThicknessRange> thickness_around(const Spectacles& lens, double radius) {
  constexpr double step = 2.0 * std::numbers::pi / meridians;
  ThicknessRange range{HUGE_VAL, -HUGE_VAL};
  int thinnest = 0, thickest = 0;
  for (int i = 0; i < meridians; ++i) {
    const auto thickness = thickness_at(lens, radius, i * step);
    if (!thickness) return std::nullopt;
    if (*thickness < range.min) range.min = *thickness, thinnest = i;
    if (*thickness > range.max) range.max = *thickness, thickest = i;
  }
  const auto refined = [&](double sign, int at) {
    const auto f = [&](double angle) { return sign * thickness_at(lens, radius, angle).value_or(sign * HUGE_VAL); };
    return sign * least(f, (at - 1) * step, (at + 1) * step);
  };
  range.min = std::fmin(range.min, refined(1.0, thinnest));
  range.max = std::fmax(range.max, refined(-1.0, thickest));
  return range;
}

EdgeThickness edge_thickness(const Spectacles& lens) {
  constexpr int rings = 256;
  const double rim = 0.5 * lens.diameter_m;
  const auto whole = [&](double radius) {
    const auto range = thickness_around(lens, radius);
    return range && range->min >= 0.0;
  };
  for (int i = 1; i <= rings; ++i) {
    double good = rim * (i - 1) / rings, bad = i == rings ? rim : rim * i / rings;
    if (whole(bad)) continue;
    for (double middle = 0.5 * (good + bad); good < middle && middle < bad; middle = 0.5 * (good + bad))
      (whole(middle) ? good : bad) = middle;
    return {thickness_around(lens, bad) ? EdgeStatus::surfaces_cross : EdgeStatus::surface_ends, std::nullopt,
            2.0 * good};
  }
  return {EdgeStatus::ok, thickness_around(lens, rim), lens.diameter_m};
}

}  // namespace sturm
