#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

namespace sturm {

/// A distance at which an astigmatic wave has no width: it spreads a point over a line there, and what lies along that
/// line looks sharp.
struct FocalLine {
  double vergence_D = 0.0;  ///< reciprocal of the distance; 0 at infinity, < 0 where no distance has it
  std::optional<double>
      direction_deg;  ///< of the line, wearer frame, (−90°, 90°]; none: a point, sharp in all directions

  /// [m]; ∞ for a vergence of 0, none below it.
  std::optional<double> distance_m() const;
};

/// The two focal lines of the wave with this curvature [D], positive = converging towards the scene, nearest first;
/// equal where the curvature has no cylinder (docs/theory.md#4-the-footprint-of-the-pupil). The line at one principal
/// curvature lies along the other one's direction.
std::array<FocalLine, 2> focal_lines(const Eigen::Matrix2d& wavefront_curvature);

}  // namespace sturm
