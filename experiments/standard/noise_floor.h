#pragma once
#include <span>

#include "compare/findings/pictures.h"
#include "experiments/run/replicates.h"

namespace sturm {

/// A metric that a noise floor has, by its name in the report.
struct FloorMetric {
  const char* name;
  double (*of)(const Image&, const Image&);
};

/// The metrics of the means of two halves of the replicates against each other.
///
/// Standard errors, of at least four replicates, by the jackknife of two samples: of each half every replicate is left
/// out in turn. Too large by √2 on average for a mean square between pictures that differ by nothing but noise, where
/// the measure is quadratic in the noise: a change that exceeds it is not chance.
PictureNoiseFloor noise_floor(const Replicates& replicates, std::span<const FloorMetric> metrics);

}  // namespace sturm
