#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/plots/plot.h"

namespace sturm {

/// The blur ellipse of one target.
struct BlurAtDistance {
  double distance_m = 0.0;  ///< ∞ allowed
  std::optional<double> accommodation_D;
  std::optional<double> semi_major_arcmin, semi_minor_arcmin;  ///< none where no ray comes through
  std::optional<double> orientation_deg;                       ///< of the long axis, wearer frame; none for a circle
};

/// Distances between which vision is clear [m], 0 ≤ near < far ≤ ∞; 0: however near.
struct ClearInterval {
  double near_m, far_m;
};

/// Blur of one eye against the distance of the target.
struct BlurCurve {
  std::string name;
  std::vector<BlurAtDistance> targets;  ///< from far to near
  double clear_arcmin = 0.0;            ///< up to this semi-axis vision counts as clear
  std::vector<ClearInterval> clear;
};

/// "clear from 31 cm to 1.2 m", "clear from 60 cm on", "clear nowhere within this range".
std::string clear_words(const std::vector<ClearInterval>& clear);

/// Semi-axes against the vergence of the target, with distances on the axis below and dioptres on the axis above. Where
/// vision is clear the ground is tinted. The table has both orientations: the wearer's and TABO. `range_arcmin` is the
/// end of the vertical axis; none: what the curves need.
Plot blur_plot(std::span<const BlurCurve> curves, std::optional<double> range_arcmin = std::nullopt);

}  // namespace sturm
