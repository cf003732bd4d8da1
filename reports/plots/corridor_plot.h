#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/plots/plot.h"

namespace sturm {

/// A lens along one line of gazes to the left and right.
struct CorridorPlace {
  double elevation_deg = 0.0;           ///< up
  std::optional<double> azimuth_deg;    ///< where the astigmatism of the error is least; none: nothing comes through,
                                        ///< or it is low so far to either side that no corridor can be told
  std::optional<double> addition_D;     ///< mean power error there
  std::optional<double> astigmatism_D;  ///< cylinder of the error there
  std::optional<double> width_deg;      ///< of the gazes about it with a cylinder below the limit; 0: none
};

struct CorridorProfile {
  std::string name;
  std::vector<CorridorPlace> places;
  double limit_D = 0.5;  ///< of the cylinder, for the width
};

/// Power along the corridor and its width, gaze up on the vertical axis as on the lens.
Plot corridor_plot(std::span<const CorridorProfile> profiles);

}  // namespace sturm
