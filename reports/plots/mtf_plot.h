#pragma once
#include <span>
#include <string>
#include <vector>

#include "reports/plots/plot.h"

namespace sturm {

/// Modulation transfer along one direction.
struct MtfCurve {
  double distance_m = 0.0;     ///< of the target, ∞ allowed
  double direction_deg = 0.0;  ///< the pattern varies along it; wearer frame
  std::string model;           ///< "rays" or "waves"
  std::vector<double> frequencies_cpd, values;
};

/// Curves of one distance share a colour, those of one direction a dash, models are told apart by width.
Plot mtf_plot(std::span<const MtfCurve> curves);

}  // namespace sturm
