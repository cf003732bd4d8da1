#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "reports/markup/html.h"
#include "reports/plots/plot.h"

namespace sturm {

/// A quantity over a lens, as the wearer looks through it, or over a pupil. Coordinates: mm on the lens about its back
/// vertex, or about the pupil's centre, x to the wearer's right, y up. Red is more everywhere: too much power.
struct LensMap {
  std::string title;       ///< plain text; \\n (two characters) begins a new line
  std::string unit = "D";  ///< of the values
  double rim_radius_mm = 0.0;
  Eigen::Vector2d fitting_cross_mm =
      Eigen::Vector2d::Zero();  ///< where the line of sight of primary gaze meets the lens
  Eigen::MatrixXd values;  ///< square, (row, column) = (y, x) from −rim to +rim in equal steps; not finite = no value
  bool signed_scale = true;                     ///< blue – white – red about 0, or light to dark from 0
  double contour_step = 0.25;                   ///< > 0; every fourth line is thick
  std::optional<Eigen::MatrixXd> limit_values;  ///< a second quantity on the same places …
  double limit = 0.0;                           ///< … whose contour at this value is drawn as a heavy line
};

/// How several maps are drawn.
struct LensMapLayout {
  std::size_t rows = 1;         ///< the maps fill the first row, then the next; their number is a multiple of it
  std::optional<double> range;  ///< end of all scales; values beyond it have the colour of the end. None: the maps' own
};

/// gnuplot's commands for maps side by side (no terminal, no output). Thick contours have their values on them.
std::string lens_map_script(std::span<const LensMap> maps, const LensMapLayout& layout = {});

/// The maps as a figure; its table has a row for each place of each map that has a value: map, x_mm, y_mm, value.
Plot lens_map_plot(std::span<const LensMap> maps, const LensMapLayout& layout = {});

/// The maps as an <svg> element for an HTML page (reports/plots/gnuplot.h). `id`: unique on the page.
Html lens_map_svg(std::span<const LensMap> maps, const std::string& id);
inline Html lens_map_svg(const LensMap& map, const std::string& id) {
  return lens_map_svg(std::span(&map, 1), id);
}

/// The same as a file of its own: SVG, or PNG.
std::string lens_map_svg_file(std::span<const LensMap> maps);
std::string lens_map_png_file(std::span<const LensMap> maps);

}  // namespace sturm
