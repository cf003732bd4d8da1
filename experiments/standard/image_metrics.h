#pragma once
#include "experiments/run/replicates.h"
#include "io/json/json.h"

namespace sturm {

inline constexpr double metrics_exposure = 1.0;  ///< of the display space of metrics and PNG files

/// "metrics" of an "images" entry: the mean of the predictions against the mean of the path-traced pictures, of which
/// there are as many. Standard errors are by the jackknife over the replicates (Efron & Stein 1981): each replicate of
/// both is left out in turn.
Json image_metrics_json(const Replicates& predicted, const Replicates& traced);

/// "noise_floor" of it: the means of two halves of the path-traced pictures against each other; and its
/// "noise_floor_uncertainty", null where there are fewer than four.
Json image_noise_floor_json(const Replicates& traced);
Json image_noise_floor_uncertainty_json(const Replicates& traced);

}  // namespace sturm
