#include "reports/plots/lens_heat_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/files/formatted_text.h"
#include "reports/markup/drawing.h"
#include "reports/markup/false_colour.h"

namespace sturm {

namespace {

constexpr double cell_width = 52.0, cell_height = 24.0, cells_left = 46.0, cells_top = 46.0, cells_gap = 26.0;
constexpr SequentialScale cell_scale{1.0, 3.0};

/// Light is little: the map runs from dark to light, the eye from empty to full.
std::string fill_of(double defocus_D) {
  return hex_colour(sequential_colour(1.0 - 0.85 * position_on(cell_scale, defocus_D)));
}

std::string cell_text(double defocus_D) {
  if (defocus_D < 5e-5) return "0";
  char text[16];
  std::snprintf(text, sizeof text, defocus_D < 0.01 ? "%.4f" : defocus_D < 0.1 ? "%.3f" : "%.2f", defocus_D);
  return text;
}

Html cell(double x, double y, const WorstError& worst) {
  const bool matters = worst.defocus_D && *worst.defocus_D > defocus_that_matters_D;
  const double inset = matters ? 1.0 : 0.0;
  Attributes square = {{"x", plain_number(x + inset)},
                       {"y", plain_number(y + inset)},
                       {"width", plain_number(cell_width - 2.0 * inset)},
                       {"height", plain_number(cell_height - 2.0 * inset)},
                       {"fill", worst.defocus_D ? fill_of(*worst.defocus_D) : "#eceff2"}};
  if (matters) square.insert(square.end(), {{"stroke", "#000000"}, {"stroke-width", "2"}});
  const bool dark = worst.defocus_D && position_on(cell_scale, *worst.defocus_D) > 0.42;
  return empty_element("rect", square) + "\n"_html +
         svg_text(x + 0.5 * cell_width, y + 0.5 * cell_height + 4.0,
                  worst.defocus_D ? cell_text(*worst.defocus_D) + (worst.without > 0 ? "*" : "") : "–", "middle", 12,
                  dark ? "#ffffff" : "#1f2328");
}

}  // namespace

Figure heat_map(const LensStudyErrors& errors, const std::string& lens) {
  const auto &gazes = errors.eccentricities_deg(), &pupils = errors.pupils_mm();
  const double panel = cell_width * static_cast<double>(pupils.size()),
               height = cells_top + cell_height * static_cast<double>(gazes.size()) + 40.0;
  const double width = cells_left + std::size(study_methods) * (panel + cells_gap);
  Html body = white_ground();
  for (std::size_t m = 0; m < std::size(study_methods); ++m) {
    const double x0 = cells_left + static_cast<double>(m) * (panel + cells_gap);
    body += svg_text(x0, 16.0, study_methods[m].name, "start", 14);
    for (std::size_t p = 0; p < pupils.size(); ++p)
      body += svg_text(x0 + cell_width * (static_cast<double>(p) + 0.5), cells_top - 8.0,
                       plain_number(pupils[p]) + " mm", "middle", 12, "#5c6670");
    for (std::size_t g = 0; g < gazes.size(); ++g) {
      const double y = cells_top + cell_height * static_cast<double>(g);
      if (m == 0)
        body +=
            svg_text(cells_left - 8.0, y + 0.5 * cell_height + 4.0, plain_number(gazes[g]) + "°", "end", 12, "#5c6670");
      for (std::size_t p = 0; p < pupils.size(); ++p)
        body += cell(x0 + cell_width * static_cast<double>(p), y,
                     errors.at(lens, study_methods[m].key, gazes[g], pupils[p]));
    }
  }
  body += svg_text(cells_left, height - 14.0,
                   "Largest error against real rays [D] over directions and distances. Black frame: above 0.05 D. *: "
                   "some views without an ellipse.",
                   "start", 12, "#5c6670");
  Figure figure;
  figure.id = "lens_study_heat_" + lens;
  figure.section = "lens_study";
  figure.title = lens + ": error by gaze and pupil";
  figure.caption = "Rows: angle between the gaze and the lens's axis. Columns: diameter of the pupil.";
  figure.svg =
      svg_document(static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height)), figure.title, body);
  return figure;
}

}  // namespace sturm
