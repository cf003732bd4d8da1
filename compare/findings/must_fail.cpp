#include "compare/findings/must_fail.h"

#include <nlohmann/json.hpp>

#include "compare/findings/measured.h"
#include "io/json/stored.h"
#include "io/json/values.h"

namespace sturm {

Json to_json(const std::vector<MutantFinding>& mutants) {
  Json list = Json::array();
  for (const MutantFinding& m : mutants)
    list.push_back({{"id", m.id},
                    {"what", m.what},
                    {"failed_as_it_must", m.failed_as_it_must ? Json(*m.failed_as_it_must) : Json(nullptr)},
                    {"value", number_or_null(m.value)},
                    {"bound", number_or_null(m.bound)}});
  return list;
}

std::vector<MutantFinding> read_must_fail(const Json& report) {
  std::vector<MutantFinding> mutants;
  for (const Json& entry : array_at(report, "must_fail"))
    mutants.push_back({.id = text_at(entry, "id"),
                       .what = text_at(entry, "what"),
                       .failed_as_it_must = boolean_at(entry, "failed_as_it_must"),
                       .value = number_at(entry, "value"),
                       .bound = number_at(entry, "bound")});
  return mutants;
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
