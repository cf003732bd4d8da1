#pragma once
#include <span>
#include <string>
#include <vector>

#include "reports/plots/plot.h"

namespace sturm {

/// A population behind one lens design: of each wearer the share of the gazes that are blurred, in any order.
struct BlurredShares {
  std::string name;
  std::vector<double> shares;  ///< 0 … 1
};

/// All designs for targets at one distance.
struct SharesAtDistance {
  double distance_m = 0.0;  ///< ∞ allowed
  std::vector<BlurredShares> designs;
};

/// A panel for each distance: how many of the wearers have at most so many blurred gazes. `clear_D` is the defocus from
/// which a gaze counts as blurred.
Plot wearers_plot(std::span<const SharesAtDistance> distances, double clear_D);

}  // namespace sturm
