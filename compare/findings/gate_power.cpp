#include "compare/findings/gate_power.h"

#include <nlohmann/json.hpp>

#include "compare/gates/gates.h"
#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Number sum_of_levels(std::span<const GateSpec> gates) {
  double sum = 0.0;
  for (const GateSpec& gate : gates) {
    if (!gate.calibration || !gate.calibration->level) return std::nullopt;
    sum += *gate.calibration->level;
  }
  return sum;
}

Json json_of(const NoticedMutation& mutation) {
  Json caught_by = Json::array();
  for (const GateThatNoticed& caught : mutation.caught_by)
    caught_by.push_back({{"gate", caught.gate},
                         {"value", number_or_null(caught.value)},
                         {"honest_value", number_or_null(caught.honest_value)},
                         {"bound", number_or_null(caught.bound)},
                         {"unit", caught.unit}});
  return {{"id", mutation.id}, {"what", mutation.what}, {"caught_by", std::move(caught_by)}};
}

NoticedMutation mutation_from(const Json& json) {
  NoticedMutation mutation{.id = text_at(json, "id"), .what = text_at(json, "what"), .caught_by = {}};
  for (const Json& caught : array_at(json, "caught_by"))
    mutation.caught_by.push_back({.gate = text_at(caught, "gate"),
                                  .value = number_at(caught, "value"),
                                  .honest_value = number_at(caught, "honest_value"),
                                  .bound = number_at(caught, "bound"),
                                  .unit = text_at(caught, "unit")});
  return mutation;
}

}  // namespace

GatePower gate_power(std::span<const GateSpec> gates, const Statistics& honest,
                     std::span<const MutatedStatistics> mutated, const Statistics* before) {
  GatePower power{.mutations = {}, .gates = gates.size(), .false_alarms_per_run = sum_of_levels(gates)};
  const std::vector<GateResult> without = evaluate_gates(gates, honest, before);
  for (const MutatedStatistics& mutation : mutated) {
    const std::vector<GateResult> with = evaluate_gates(gates, mutation.statistics, before);
    NoticedMutation noticed{.id = mutation.id, .what = mutation.what, .caught_by = {}};
    for (std::size_t i = 0; i < gates.size(); ++i)
      if (without[i].has_passed() && !with[i].has_passed())
        noticed.caught_by.push_back({.gate = gates[i].id,
                                     .value = with[i].value,
                                     .honest_value = without[i].value,
                                     .bound = gates[i].bound,
                                     .unit = gates[i].unit});
    power.mutations.push_back(std::move(noticed));
  }
  return power;
}

Json to_json(const GatePower& power) {
  Json mutations = Json::array();
  for (const NoticedMutation& mutation : power.mutations) mutations.push_back(json_of(mutation));
  return {{"mutations", std::move(mutations)},
          {"gates", count_or_null(power.gates)},
          {"false_alarms_per_run", number_or_null(power.false_alarms_per_run)}};
}

GatePower read_gate_power(const Json& report) {
  const Json& section = value_at(report, "gate_power");
  GatePower power{.mutations = {},
                  .gates = count_at(section, "gates"),
                  .false_alarms_per_run = number_at(section, "false_alarms_per_run")};
  for (const Json& mutation : array_at(section, "mutations")) power.mutations.push_back(mutation_from(mutation));
  return power;
}

void measure_gate_power(const Json& report, Measurements& out) {
  for (const NoticedMutation& mutation : read_gate_power(report).mutations)
    out.push_back({.section = "gate_power",
                   .subject = mutation.id,
                   .quantity = "gates that notice a mutation",
                   .value = static_cast<double>(mutation.caught_by.size())});
}

std::span<const StatisticRule> gate_power_rules() {
  static constexpr StatisticRule rules[] = {
      {"mutation_min_gates", "gate_power", "gates that notice a mutation", nullptr, Extreme::Of::Smallest}};
  return rules;
}

}  // namespace sturm
