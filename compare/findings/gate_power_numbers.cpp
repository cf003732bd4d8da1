#include "compare/findings/gate_power_numbers.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"

namespace sturm {

void measure_gate_power(const Json& report, Measurements& out) {
  for (const Json& mutation : array_at(report, "gate_power/mutations"))
    out.push_back({.section = "gate_power",
                   .subject = text_at(mutation, "id"),
                   .quantity = "gates that notice a mutation",
                   .value = static_cast<double>(array_at(mutation, "caught_by").size())});
}

std::span<const StatisticRule> gate_power_rules() {
  static constexpr StatisticRule rules[] = {
      {"mutation_min_gates", "gate_power", "gates that notice a mutation", nullptr, Extreme::Of::Smallest}};
  return rules;
}

}  // namespace sturm
