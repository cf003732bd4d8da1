#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

namespace sturm {

/// The bundle of rays that a point of the retina sends out of the eye, to first order: the ray through pupil point p
/// stands at (offset + d·slope) p at the distance d.
struct SturmConoid {
  Eigen::Matrix2d offset, slope;  ///< [m/m], [1/m]
  double pupil_radius_m = 0.0;
  double end_m = 0.0;  ///< where the drawing ends, > 0
};

/// Distances [m] within (0, end) at which all rays meet one line, and the one between them, or in front, where the
/// larger semi-axis is least.
struct ConoidPlaces {
  std::optional<double> near_line_m, far_line_m, least_confusion_m;
};
ConoidPlaces places_of(const SturmConoid& conoid);

/// The conoid of Sturm in space, seen from the side and a little from above, as an SVG document: cross sections, rays
/// from the rim of the pupil, both focal lines and the circle of least confusion, with their distances. Across, it is
/// drawn much larger than along; the factor stands below. [Kakimoto2010] fig. 10
std::string sturm_conoid_svg(const SturmConoid& conoid, const std::string& label);

}  // namespace sturm
