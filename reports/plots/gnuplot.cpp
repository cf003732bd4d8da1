#include "reports/plots/gnuplot.h"

#include <algorithm>
#include <regex>

#include "io/files/child_program.h"
#include "io/files/error.h"
#include "reports/markup/escaped.h"

namespace sturm {

namespace {

std::string run_gnuplot(std::string_view script) {
  // The user's own start-up file must not restyle the report. What comes in by itself gnuplot asks the system for byte
  // by byte; from a file with a name it reads blocks.
  return output_of({{"gnuplot", "--default-settings", "/dev/stdin"},
                    "the report's plots need gnuplot, which cannot be started (Debian package gnuplot-nox)",
                    "gnuplot could not draw a plot of the report"},
                   script);
}

/// gnuplot does not tell of a temporary folder that is full.
std::string whole_picture(std::string picture, std::string_view end) {
  if (picture.find(end, picture.size() - std::min(picture.size(), 2 * end.size() + 8)) == std::string::npos)
    throw RuntimeFailure("gnuplot wrote no whole picture");
  return picture;
}

/// The picture's own element, without what only a free-standing SVG file needs.
Html for_inline_use(std::string svg, const PlotFrame& frame) {
  const std::size_t start = svg.find("<svg");
  const std::size_t end = svg.rfind("</svg>");
  if (start == std::string::npos || end == std::string::npos) throw RuntimeFailure("gnuplot wrote no SVG picture");
  svg = svg.substr(start, end + 6 - start);
  svg = std::regex_replace(svg, std::regex(R"re(\sxmlns(:xlink)?="[^"]*")re"), "");
  svg = std::regex_replace(svg, std::regex(R"re(\sfont-family="[^"]*")re"), "");
  svg = std::regex_replace(svg, std::regex("xlink:href="), "href=");
  // gnuplot gives each curve an id, some of them twice; nothing refers to those. Several plots share the page, so the
  // ids that are needed must not meet.
  svg = std::regex_replace(svg, std::regex(R"re(\sid="gnuplot_[^"]*")re"), "");
  svg = std::regex_replace(svg, std::regex(R"re((\sid=['"]|href=['"]#))re"), "$1" + frame.id + "-");
  svg = std::regex_replace(svg, std::regex(R"re(url\(#)re"), "url(#" + frame.id + "-");
  svg = std::regex_replace(svg, std::regex("<title>gnuplot_plot_[^<]*</title>"), "");
  svg = std::regex_replace(svg, std::regex("<title>Gnuplot</title>\\s*<desc>[^<]*</desc>"), "");
  svg.insert(4, " class=\"plot\" role=\"img\" aria-label=\"" + escaped(frame.label) + "\"");
  return Html::trusted(svg + "\n");
}

}  // namespace

std::string gnuplot_file(std::string_view script, const PlotFrame& frame) {
  const std::string setup = "set encoding utf8\nset terminal svg size " + std::to_string(frame.width) + "," +
                            std::to_string(frame.height) + " dynamic enhanced font \"sans-serif,13\"\n";
  return whole_picture(run_gnuplot(setup + std::string(script) + "\n"), "</svg>");
}

Html gnuplot_svg(std::string_view script, const PlotFrame& frame) {
  return for_inline_use(gnuplot_file(script, frame), frame);
}

std::string gnuplot_labelled_file(std::string_view script, const PlotFrame& frame) {
  std::string svg = gnuplot_svg(script, frame).markup();
  svg.insert(
      4,
      " xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" font-family=\"sans-serif\"");
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + svg;
}

std::string gnuplot_png(std::string_view script, const PlotFrame& frame) {
  const std::string setup = "set encoding utf8\nset terminal pngcairo size " + std::to_string(2 * frame.width) + "," +
                            std::to_string(2 * frame.height) +
                            " enhanced font \"sans-serif,13\" fontscale 1.5 linewidth 2 pointscale 2\n";
  return whole_picture(run_gnuplot(setup + std::string(script) + "\n"), "IEND");
}

std::string gnuplot_pdf(std::string_view script, const PlotFrame& frame) {
  constexpr double pixels_per_inch = 96.0;
  const std::string setup = "set encoding utf8\nset terminal pdfcairo size " +
                            std::to_string(frame.width / pixels_per_inch) + "in," +
                            std::to_string(frame.height / pixels_per_inch) + "in enhanced font \"sans-serif,9.75\"\n";
  return whole_picture(run_gnuplot(setup + std::string(script) + "\n"), "%%EOF");
}

}  // namespace sturm
