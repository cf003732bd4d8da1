#include "compare/findings/reference.h"

#include <initializer_list>

#include "io/json/stored.h"

namespace sturm {

namespace {

/// The largest of some relative errors over all reference cases, as one measurement.
Measurement worst_of(const Json& report, const char* statistic, std::initializer_list<const char*> names) {
  const Number cases = number_at(report, "reference/cases");
  Extreme worst;
  if (cases && *cases >= 1.0)
    for (const char* name : names)
      worst.add(number_at(report, std::string("reference/max_relative_error/") + name), name);
  return {.section = "reference",
          .quantity = "largest relative error",
          .value = worst.result().value,
          .cases = cases ? static_cast<std::uint64_t>(*cases) : 0,
          .worst_case = worst.result().worst_case,
          .statistic = statistic};
}

}  // namespace

void measure_reference(const Json& report, Measurements& out) {
  out.push_back(worst_of(report, "conoid_reference_max_relative_error", {"conoid_semi_axes", "conoid_covariance"}));
  out.push_back(worst_of(report, "sin2_reference_max_relative_error", {"sin2_closed_form"}));
  const Json& errors = value_at(report, "reference/max_relative_error");
  if (!errors.is_object()) return;
  for (const auto& [key, error] : errors.items())
    out.push_back({.section = "reference",
                   .subject = key,
                   .quantity = "relative error",
                   .value = number_at(error, ""),
                   .better = Better::Less,
                   .run_name = "reference: relative error of " + key});
}

}  // namespace sturm
