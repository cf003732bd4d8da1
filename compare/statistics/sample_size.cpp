#include "compare/statistics/sample_size.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/statistics/statistics.h"

namespace sturm {

namespace {

/// N with se(1)/√N·(sigmas + z_power) = δ, se(1) the relative standard error of one sample.
std::uint64_t size_for(const SampleSizeRequest& r, double variance_of_one) {
  if (!(r.relative_difference > 0.0 && r.sigmas > 0.0 && r.power > 0.0 && r.power < 1.0 && variance_of_one > 0.0))
    throw std::domain_error("sample size: difference, sigmas and scatter must be positive, the power between 0 and 1");
  const double deviations = r.sigmas + normal_upper_quantile(1.0 - r.power);
  if (!(deviations > 0.0)) return 1;  // so small a power is had by chance
  const double ratio = deviations / r.relative_difference;
  const double n =
      std::ceil((r.both_measured ? 2.0 : 1.0) * variance_of_one * ratio * ratio * (1.0 - 1e-12));  // 4e6, not 4e6 + 1
  if (!(n < 0x1p63)) throw std::domain_error("sample size: more than 2^63 samples");
  return static_cast<std::uint64_t>(std::max(1.0, n));
}

}  // namespace

std::uint64_t rays_for_semi_axis(const SampleSizeRequest& request, double kurtosis) {
  return size_for(request, 0.25 * (kurtosis - 1.0));
}

std::uint64_t samples_for_mean(const SampleSizeRequest& request, double coefficient_of_variation) {
  return size_for(request, coefficient_of_variation * coefficient_of_variation);
}

}  // namespace sturm
