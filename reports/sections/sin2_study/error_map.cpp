#include <cmath>
#include <cstdio>

#include "compare/studies/sin2/summary.h"
#include "io/files/formatted_text.h"
#include "reports/markup/drawing.h"
#include "reports/markup/false_colour.h"
#include "reports/sections/sin2_study/figures.h"

namespace sturm {

namespace {

constexpr double cell_height = 24.0, left = 62.0, top = 58.0, panel_gap = 56.0, panel_width = 1120.0 - left - 10.0;
constexpr SequentialScale scale{10.0, 3.0};  // 0.01 … 10 D

struct Panel {
  RayModel model;
  const char* title;
};
constexpr Panel panels[] = {{RayModel::sin2_radial, "sin², vergences added"},
                            {RayModel::metalstigmatism, "focal distances added, as printed"}};

std::vector<std::vector<Number>> map_of(const Sin2ReferenceView& view, RayModel model) {
  for (const Sin2Map& map : view.maps)
    if (map.ray_model == model) return map.error_D;
  return {};
}

std::string number_text(double error_D) {
  if (error_D < 5e-4) return "0";
  char text[16];
  std::snprintf(text, sizeof text, error_D < 1.0 ? "%.2f" : error_D < 10.0 ? "%.1f" : "%.0f", error_D);
  return text;
}

std::string reference_distance(const Sin2StudyFindings& found) {
  const Number metres = finite(found.conditions.reference_distance_m);
  return metres ? plain_number(*metres) + " m" : "infinity";
}

/// A square of the map; "–" on grey where the model has no second moments.
Html cell(double x, double y, double width, const std::optional<double>& error_D) {
  const bool noticed = error_D && *error_D > noticeable_defocus_D;
  const double position = error_D ? position_on(scale, *error_D) : 0.0, inset = noticed ? 1.0 : 0.0;
  const std::string fill = error_D ? hex_colour(sequential_colour(1.0 - 0.85 * position)) : "#cfd4d9";
  Attributes square = {{"x", coordinate(x + inset)},
                       {"y", coordinate(y + inset)},
                       {"width", coordinate(width - 2.0 * inset)},
                       {"height", coordinate(cell_height - 2.0 * inset)},
                       {"fill", fill}};
  if (noticed) square.insert(square.end(), {{"stroke", "#000000"}, {"stroke-width", "1.5"}});
  return empty_element("rect", square) + "\n"_html +
         svg_text(x + 0.5 * width, y + 0.5 * cell_height + 4.0, error_D ? number_text(*error_D) : "–", "middle", 11,
                  position > 0.5 ? "#ffffff" : "#1f2328");
}

Html panel_svg(const Sin2ReferenceView& view, const Panel& panel, double y0) {
  const std::vector<double>&spheres = view.spheres_D, &cylinders = view.cylinders_D;
  const std::vector<std::vector<Number>> rows = map_of(view, panel.model);
  const double width = panel_width / static_cast<double>(spheres.size());
  Html body = svg_text(left, y0 - 36.0, panel.title, "start", 15) +
              svg_text(left - 8.0, y0 - 10.0, "C \\ S′", "end", 12, "#5c6670");
  for (std::size_t s = 0; s < spheres.size(); ++s)
    body += svg_text(left + width * (static_cast<double>(s) + 0.5), y0 - 10.0, plain_number(spheres[s]), "middle", 12,
                     "#5c6670");
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double y = y0 + cell_height * static_cast<double>(row);
    body += svg_text(left - 8.0, y + 0.5 * cell_height + 4.0, plain_number(cylinders[row]), "end", 12, "#5c6670");
    for (std::size_t s = 0; s < rows[row].size(); ++s)
      body += cell(left + width * static_cast<double>(s), y, width, rows[row][s]);
  }
  return body;
}

}  // namespace

std::optional<Figure> sin2_error_map(const Sin2StudyFindings& found) {
  const std::size_t rows = found.reference_view.cylinders_D.size();
  if (rows == 0 || found.reference_view.spheres_D.empty()) return std::nullopt;
  const double panel_height = cell_height * static_cast<double>(rows);
  Html body = white_ground();
  double y = top;
  for (const Panel& panel : panels) {
    body += panel_svg(found.reference_view, panel, y);
    y += panel_height + panel_gap + 8.0;
  }
  const double height = y - panel_gap + 22.0;
  body += svg_text(left, height - 12.0,
                   "Error of the blur's half-width over the pupil's radius [D]. Black frame: above 0.25 D. Grey: the "
                   "pole lies within the "
                   "pupil, so there is no second moment.",
                   "start", 12, "#5c6670");
  Figure figure;
  figure.id = "sin2_study_map";
  figure.section = "sin2_study";
  figure.title = "Error over sphere and cylinder";
  figure.caption = "A target where the eye is focused (" + reference_distance(found) +
                   "), so that S′ = S + 1/d − A is the sphere itself. Columns: sphere S′ [D]. Rows: cylinder C [D]. "
                   "The error does not "
                   "depend on the pupil. In the first row there is no cylinder: sin² is exact there.";
  figure.svg = svg_document(1120, static_cast<int>(std::lround(height)), figure.title, body);
  return figure;
}

}  // namespace sturm
