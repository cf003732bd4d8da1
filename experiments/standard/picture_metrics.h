#pragma once
#include <map>
#include <string>

#include "compare/findings/pictures.h"
#include "experiments/run/replicates.h"

namespace sturm {

/// The mean of the predictions against the mean of the path-traced pictures, of which there are as many. Standard
/// errors are by the jackknife over the replicates (Efron & Stein 1981): each replicate of both is left out in turn.
std::map<std::string, PictureMetric> picture_metrics(const Replicates& predicted, const Replicates& traced);

/// The noise floor of these metrics.
PictureNoiseFloor noise_floor_of_metrics(const Replicates& traced);

}  // namespace sturm
