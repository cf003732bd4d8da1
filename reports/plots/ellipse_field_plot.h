#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lensmodel/ellipse.h"
#include "reports/plots/plot.h"

namespace sturm {

/// The blur of a target in one direction of gaze.
struct FieldSpot {
  double azimuth_deg = 0.0, elevation_deg = 0.0;  ///< to the wearer's right, up
  std::optional<Ellipse> ellipse;  ///< [arcmin], on the axes of the turned eye; none: no ray comes through
};

struct EllipseField {
  std::string title;
  std::vector<FieldSpot> spots;
  double step_deg = 10.0;     ///< between neighbours
  double clear_arcmin = 0.0;  ///< a larger semi-axis is drawn in the colour of what is not clear
};

/// Fields side by side; all ellipses are drawn on one scale, so large that the largest one fills its cell, or one with
/// the semi-axis `range_arcmin`.
Plot ellipse_field_plot(std::span<const EllipseField> fields, std::optional<double> range_arcmin = std::nullopt);

}  // namespace sturm
