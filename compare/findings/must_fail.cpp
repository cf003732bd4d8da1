#include "compare/findings/must_fail.h"

#include "compare/findings/measured.h"
#include "io/json/stored.h"

namespace sturm {

void measure_must_fail(const Json& report, Measurements& out) {
  for (const Json& mutant : array_at(report, "must_fail")) {
    const std::string id = text_at(mutant, "id");
    const bool admits = boolean_at(mutant, "failed_as_it_must").value_or(false);
    const Number value = admits ? number_at(mutant, "value") : std::nullopt;
    out.push_back(
        {.section = "must_fail", .subject = id, .quantity = "value", .value = value, .statistic = "must_fail/" + id});
    out.push_back({.section = "must_fail",
                   .subject = id,
                   .quantity = "value over its bound",
                   .value = quotient(value, number_at(mutant, "bound"))});
  }
}

std::span<const StatisticRule> must_fail_rules() {
  static constexpr StatisticRule rules[] = {
      {"must_fail_min_value_over_bound", "must_fail", "value over its bound", nullptr, Extreme::Of::Smallest}};
  return rules;
}

}  // namespace sturm
