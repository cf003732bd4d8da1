#include "reports/plots/sturm_conoid_svg.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "io/files/formatted_text.h"
#include "lensmodel/best_accommodation.h"
#include "lensmodel/ellipse.h"
#include "reports/markup/drawing.h"

namespace sturm {

namespace {

constexpr int conoid_width = 900, conoid_height = 420, conoid_left = 80, conoid_right = 60;

Eigen::Matrix2d map_at(const SturmConoid& c, double distance) {
  return c.offset + distance * c.slope;
}

/// Roots of det(A + dB) = 0 within (0, end), in order.
std::vector<double> focal_distances(const SturmConoid& c) {
  const double constant = c.offset.determinant(), square = c.slope.determinant();
  const double linear = c.offset(0, 0) * c.slope(1, 1) + c.offset(1, 1) * c.slope(0, 0) -
                        c.offset(0, 1) * c.slope(1, 0) - c.offset(1, 0) * c.slope(0, 1);
  std::vector<double> roots;
  if (square == 0.0) {
    if (linear != 0.0) roots.push_back(-constant / linear);
  } else if (const double discriminant = linear * linear - 4.0 * square * constant; discriminant >= 0.0) {
    const double sum = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));  // no cancellation
    roots = {sum / square, sum == 0.0 ? 0.0 : constant / sum};
  }
  std::erase_if(roots, [&](double d) { return !(d > 0.0 && d < c.end_m); });
  std::sort(roots.begin(), roots.end());
  return roots;
}

/// Where the larger semi-axis is least: X is affine in the distance as it is in an accommodation.
double least_confusion(const SturmConoid& c, double low, double high) {
  return low + best_accommodation(map_at(c, low), -c.slope, high - low);
}

/// Axonometric: the distance runs to the right, "up" upwards, and "to the wearer's right" towards the beholder.
struct View {
  double along, across;  ///< pixels per metre
  double baseline;

  std::string at(double distance, const Eigen::Vector2d& offset) const {
    return coordinate(conoid_left + along * distance - 0.42 * across * offset.x()) + " " +
           coordinate(baseline - across * offset.y() + 0.26 * across * offset.x());
  }
};

/// Cross section of the conoid, drawn with `style`.
Html section(const SturmConoid& c, const View& view, double distance, const Attributes& style) {
  constexpr int points = 72;
  std::string path;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    path +=
        (i ? "L" : "M") +
        view.at(distance, map_at(c, distance) * (c.pupil_radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  Attributes attributes = {{"d", path + "Z"}};
  attributes.insert(attributes.end(), style.begin(), style.end());
  return empty_element("path", attributes);
}

Html rays(const SturmConoid& c, const View& view) {
  constexpr int count = 24;
  std::string path;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector2d p = c.pupil_radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    path += "M" + view.at(0.0, c.offset * p) + "L" + view.at(c.end_m, map_at(c, c.end_m) * p);
  }
  return empty_element("path", {{"d", path}, {"fill", "none"}, {"stroke", "#9bb4cf"}, {"stroke-width", "0.7"}});
}

}  // namespace

ConoidPlaces places_of(const SturmConoid& c) {
  ConoidPlaces places;
  const std::vector<double> lines = focal_distances(c);
  if (!lines.empty()) places.near_line_m = lines.front();
  if (lines.size() > 1) places.far_line_m = lines.back();
  if (lines.size() > 1 && lines.front() < lines.back())
    places.least_confusion_m = least_confusion(c, lines.front(), lines.back());
  return places;
}

std::string sturm_conoid_svg(const SturmConoid& c, const std::string& label) {
  double largest = c.pupil_radius_m;
  for (const double d : {0.0, c.end_m})
    largest = std::max(largest, Ellipse::image_of_disc(map_at(c, d), c.pupil_radius_m).semi_major);
  const View view{(conoid_width - conoid_left - conoid_right) / c.end_m, 0.3 * conoid_height / largest,
                  0.46 * conoid_height};
  Html body = empty_element("path", {{"d", "M" + view.at(0.0, {0.0, 0.0}) + "L" + view.at(c.end_m, {0.0, 0.0})},
                                     {"stroke", "#888"},
                                     {"stroke-dasharray", "6 4"}}) +
              rays(c, view);
  constexpr int sections = 16;
  for (int i = 0; i <= sections; ++i)
    body += section(c, view, c.end_m * i / sections,
                    {{"fill", "#2b6cb0"}, {"fill-opacity", "0.07"}, {"stroke", "#2b6cb0"}, {"stroke-width", "0.8"}});
  body += section(c, view, 0.0, {{"fill", "none"}, {"stroke", "#111"}, {"stroke-width", "2.2"}});

  const double text_y = conoid_height - 62;
  const auto mark = [&](double distance, const std::string& name, const char* colour, double lift) {
    const double x = conoid_left + view.along * distance;
    body += section(c, view, distance,
                    {{"fill", colour}, {"fill-opacity", "0.25"}, {"stroke", colour}, {"stroke-width", "3"}}) +
            empty_element("path", {{"d", "M" + coordinate(x) + " " + coordinate(view.baseline) + "V" +
                                             coordinate(text_y - 14 - lift)},
                                   {"stroke", colour},
                                   {"stroke-dasharray", "2 3"}}) +
            svg_text(x, text_y - lift, name + " " + plain_number(distance, 4) + " m");
  };
  const ConoidPlaces places = places_of(c);
  body += svg_text(conoid_left, text_y, "pupil");
  if (places.near_line_m) mark(*places.near_line_m, "focal line", "#c0392b", 0);
  if (places.least_confusion_m) mark(*places.least_confusion_m, "least confusion", "#1e8449", 20);
  if (places.far_line_m) mark(*places.far_line_m, "focal line", "#c0392b", 0);
  body += svg_text(0.5 * conoid_width, conoid_height - 18,
                   "distance to " + plain_number(c.end_m, 4) + " m; across " +
                       plain_number(view.across / view.along, 3) + " times as large as along");
  return svg_document(conoid_width, conoid_height, label, body);
}

}  // namespace sturm
