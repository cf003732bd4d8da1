#pragma once
#include <cstdint>

namespace sturm {

/// What a measurement by independent rays is meant to see.
struct SampleSizeRequest {
  double relative_difference = 1e-3;  ///< > 0, of the quantity itself
  double sigmas = 4.0;                ///< > 0: a difference counts from this many standard errors on
  double power = 0.5;  ///< in (0, 1): chance that the difference, if it is there, counts; 0.5: it counts on average
  bool both_measured = false;  ///< the other side is measured by as many rays; otherwise it is known
};

/// Number of independent rays for a semi-axis 2·√variance whose rays have the kurtosis κ > 1 along it (2 for a linear
/// image of a uniform disc): relative standard error ½·√((κ − 1)/N) (docs/theory.md#71-from-a-bundle-of-rays), hence N
/// = (κ − 1)/4·((sigmas + z_power)/δ)², twice that for two measurements. Rounded up. Throws std::domain_error for
/// values outside their range.
std::uint64_t rays_for_semi_axis(const SampleSizeRequest& request, double kurtosis);

/// The same for a mean whose single samples have the coefficient of variation `deviation`/mean > 0: N = (cv·(sigmas +
/// z_power)/δ)².
std::uint64_t samples_for_mean(const SampleSizeRequest& request, double coefficient_of_variation);

}  // namespace sturm
