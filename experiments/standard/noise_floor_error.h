#pragma once
#include <functional>
#include <optional>

#include "experiments/run/replicates.h"

namespace sturm {

/// Standard error of a measure of the means of two halves of at least four replicates, by the jackknife of two samples:
/// of each half every replicate is left out in turn. None for fewer. Too large by √2 on average for a mean square
/// between pictures that differ by nothing but noise, where the measure is quadratic in the noise: a change that
/// exceeds it is not chance.
std::optional<double> noise_floor_error(const Replicates& replicates,
                                        const std::function<double(const Image&, const Image&)>& measure);

}  // namespace sturm
