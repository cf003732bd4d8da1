#pragma once
#include <string>

#include "io/specs/worn_eye_spec.h"
#include "lensmodel/power_matrix.h"
#include "reports/plots/corridor_plot.h"
#include "reports/plots/ellipse_field_plot.h"

namespace sturm {

/// The gazes of a field: both angles from −reach to +reach [deg].
struct GazeGrid {
  double reach_deg = 30.0, step_deg = 10.0;
};

/// Blur ellipses (conoid) of targets at one distance for an eye that turns to them.
EllipseField ellipse_field(const WornEye& worn, const std::string& name, double distance_m, const GazeGrid& gazes,
                           double clear_D);

/// Mean power and cylinder of what the lens gives as worn less `nominal`, at each elevation from −40° to 20° where the
/// cylinder is least within ±15° to the sides, and how wide it stays below `limit_D` about there (1/8° steps).
CorridorProfile corridor_profile(const Spectacles& lens, const PowerMatrix& nominal, double rotation_center_m,
                                 const std::string& name, double limit_D);

}  // namespace sturm
