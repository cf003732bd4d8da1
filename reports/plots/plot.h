#pragma once
#include <string>

#include "reports/plots/gnuplot.h"

namespace sturm {

/// A figure together with the numbers that it shows.
struct Plot {
  std::string script;  ///< gnuplot's commands, without terminal and output
  PlotFrame frame;
  std::string csv;  ///< with a row of headings; units stand in the headings
};

/// Whether `name` ends in one of .svg, .png and .pdf, which a figure can be written as.
bool is_picture_name(const std::string& name);

/// The figure as a file of the kind that its name says. Throws RuntimeFailure where gnuplot is missing or complains.
std::string plot_file(const Plot& plot, const std::string& name);

}  // namespace sturm
