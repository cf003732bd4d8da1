#include "compare/findings/must_fail.h"

#include "compare/findings/measured.h"
#include "io/json/record.h"

namespace sturm {

template <>
inline constexpr auto record_members<MutantFinding> = std::tuple{
    member("id", &MutantFinding::id),
    member("what", &MutantFinding::what),
    member("failed_as_it_must", &MutantFinding::failed_as_it_must),
    member("value", &MutantFinding::value),
    member("bound", &MutantFinding::bound),
};

Json to_json(const std::vector<MutantFinding>& mutants) {
  return json_from(mutants);
}

std::vector<MutantFinding> read_must_fail(const Json& report) {
  return record_from<std::vector<MutantFinding>>(value_at(report, "must_fail"));
}

void measure_must_fail(const Json& report, Measurements& out) {
  for (const MutantFinding& mutant : read_must_fail(report)) {
    const Number value = mutant.failed_as_it_must.value_or(false) ? mutant.value : std::nullopt;
    out.push_back({.section = "must_fail",
                   .subject = mutant.id,
                   .quantity = "value",
                   .value = value,
                   .statistic = "must_fail/" + mutant.id});
    out.push_back({.section = "must_fail",
                   .subject = mutant.id,
                   .quantity = "value over its bound",
                   .value = quotient(value, mutant.bound)});
  }
}

std::span<const StatisticRule> must_fail_rules() {
  static constexpr StatisticRule rules[] = {
      {"must_fail_min_value_over_bound", "must_fail", "value over its bound", nullptr, Extreme::Of::Smallest}};
  return rules;
}

}  // namespace sturm
