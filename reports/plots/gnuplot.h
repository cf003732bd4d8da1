#pragma once
#include <string>
#include <string_view>

#include "reports/markup/html.h"

namespace sturm {

struct PlotFrame {
  std::string id;                 ///< unique on the page: prefix of every id inside the picture
  std::string label;              ///< what the picture shows, for those who cannot see it; plain text
  int width = 560, height = 400;  ///< [px] at its natural size; it scales with its place
};

/// Runs gnuplot on `script` (which must not set a terminal or output) and returns its plot as an <svg> element for an
/// HTML page: no XML prolog, no namespace addresses, no fixed fonts. Throws RuntimeFailure if gnuplot is missing or
/// complains.
Html gnuplot_svg(std::string_view script, const PlotFrame& frame);

/// The same picture as an SVG file of its own.
std::string gnuplot_file(std::string_view script, const PlotFrame& frame);

/// An SVG file that has the label and fonts of the page's pictures.
std::string gnuplot_labelled_file(std::string_view script, const PlotFrame& frame);

/// The same plot as a PNG file, at twice the natural size.
std::string gnuplot_png(std::string_view script, const PlotFrame& frame);

/// The same plot as a PDF file of its natural size, 96 px to the inch.
std::string gnuplot_pdf(std::string_view script, const PlotFrame& frame);

}  // namespace sturm
