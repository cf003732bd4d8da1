#include <cstdio>
#include <stdexcept>

#include "app/commands.h"
#include "compare/statistics/sample_size.h"
#include "io/files/error.h"

namespace sturm {

int plan_samples_command(const PlanOptions& options) {
  const SampleSizeRequest request{options.relative_difference, options.sigmas, options.power, options.both_measured};
  try {
    const std::uint64_t n = options.coefficient_of_variation
                                ? samples_for_mean(request, *options.coefficient_of_variation)
                                : rays_for_semi_axis(request, options.kurtosis);
    std::printf("%llu\n", static_cast<unsigned long long>(n));
  } catch (const std::domain_error& error) {
    throw InputError("", "", error.what(), "a difference that can be seen");
  }
  return 0;
}

}  // namespace sturm
