#include "reports/plots/ellipse_layers_svg.h"

#include <algorithm>
#include <cmath>

#include "io/files/formatted_text.h"
#include "lensmodel/units.h"
#include "reports/markup/drawing.h"
#include "reports/markup/pictures.h"

namespace sturm {

namespace {

constexpr int layer_width = 380, layer_gap = 26, layers_top = 44, layers_left = 44, layers_bottom = 52;

/// Angles [deg] whose tangents fit: steps of 10°, or of 5° or 2° in a narrow field.
std::vector<int> angle_ticks(double half) {
  const double reach = std::atan(half) / radians_per_degree;
  const int step = reach > 35.0 ? 20 : reach > 15.0 ? 10 : reach > 6.0 ? 5 : 2;
  std::vector<int> ticks;
  for (int angle = -step * static_cast<int>(reach / step); angle <= reach; angle += step) ticks.push_back(angle);
  return ticks;
}

std::string degrees(int angle) {
  return (angle < 0 ? "−" : "") + std::to_string(std::abs(angle)) + "°";
}

Html grid_line(const std::string& path) {
  return empty_element("path", {{"d", path}, {"stroke", "#e3e3e3"}});
}

std::string title_of(const EllipseLayer& layer) {
  return std::isinf(layer.distance_m) ? "∞" : plain_number(100.0 * layer.distance_m, 4) + " cm";
}

}  // namespace

std::string ellipse_layers_svg(const std::vector<EllipseLayer>& layers, double half_width, double half_height,
                               double drawn_scale, const std::string& label) {
  const double scale = 0.5 * layer_width / half_width;  // pixels per tangent
  const int layer_height = std::max(40, static_cast<int>(std::lround(2.0 * half_height * scale)));
  Html body;
  for (std::size_t n = 0; n < layers.size(); ++n) {
    const double x0 = layers_left + static_cast<double>(n) * (layer_width + layer_gap), cx = x0 + 0.5 * layer_width,
                 cy = layers_top + 0.5 * layer_height;
    const std::string clip = "layer" + std::to_string(n);
    Attributes frame = {{"x", coordinate(x0)},
                        {"y", std::to_string(layers_top)},
                        {"width", std::to_string(layer_width)},
                        {"height", std::to_string(layer_height)}};
    body += inline_element("clipPath", {{"id", clip}}, empty_element("rect", frame)) +
            svg_text(cx, layers_top - 14, title_of(layers[n]), "middle", 15);
    for (const int angle : angle_ticks(half_width)) {
      const double x = cx + scale * std::tan(radians_per_degree * angle);
      body += grid_line("M" + coordinate(x) + " " + std::to_string(layers_top) + "v" + std::to_string(layer_height)) +
              svg_text(x, layers_top + layer_height + 17, degrees(angle));
    }
    for (const int angle : angle_ticks(half_height)) {
      const double y = cy - scale * std::tan(radians_per_degree * angle);
      body += grid_line("M" + coordinate(x0) + " " + coordinate(y) + "h" + std::to_string(layer_width));
      if (n == 0) body += svg_text(x0 - 6, y + 4, degrees(angle), "end");
    }
    Html ellipses;
    for (const PlacedEllipse& e : layers[n].ellipses)
      ellipses +=
          svg_ellipse(e.ellipse, scale * drawn_scale, cx + scale * e.centre.x(), cy - scale * e.centre.y(), "blur");
    body += inline_element("g",
                           {{"clip-path", "url(#" + clip + ")"},
                            {"fill", "#2b6cb0"},
                            {"fill-opacity", "0.35"},
                            {"stroke", "#1a4f8b"},
                            {"stroke-width", "0.8"}},
                           ellipses);
    frame.insert(frame.end(), {{"fill", "none"}, {"stroke", "#555"}});
    body += empty_element("rect", frame);
  }
  const int width = layers_left + static_cast<int>(layers.size()) * (layer_width + layer_gap) - layer_gap + 14,
            height = layers_top + layer_height + layers_bottom;
  body += svg_text(0.5 * width, height - 12,
                   "field angle; ellipses drawn " + plain_number(drawn_scale) + " times as large as they are");
  return svg_document(width, height, label, body);
}

}  // namespace sturm
