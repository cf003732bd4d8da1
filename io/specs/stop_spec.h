#pragma once
#include <cstdint>
#include <optional>

#include "io/json/json.h"

namespace sturm {

/// When a picture is good enough; samples_per_pixel stays the upper bound.
struct StopSpec {
  std::optional<double> seconds;  ///< budget for path tracing [s], of one picture (a stereo pair is two)
  std::optional<double>
      relative_error;  ///< root of the relative MSE that is aimed at (as compare/metrics/relative_mse.h counts it)
};

/// Which tiles get more samples than others.
struct AdaptiveSpec {
  int tile_px = 8;                 ///< side of the squares whose pixels share one number of samples
  int min_samples_per_pixel = 32;  ///< multiple of 4; the first pass, before anything is known
};

/// Reads method.stop and method.adaptive where they are, given samples_per_pixel. Throws InputError where they
/// contradict each other.
StopSpec read_stop(const Json& method, const Source& where, std::uint64_t samples_per_pixel);
std::optional<AdaptiveSpec> read_adaptive(const Json& method, const Source& where);

}  // namespace sturm
