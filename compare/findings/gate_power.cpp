#include "compare/findings/gate_power.h"

#include "compare/gates/gates.h"
#include "io/json/record.h"

namespace sturm {

template <>
inline constexpr auto record_members<GateThatNoticed> = std::tuple{
    member("gate", &GateThatNoticed::gate),
    member("value", &GateThatNoticed::value),
    member("honest_value", &GateThatNoticed::honest_value),
    member("bound", &GateThatNoticed::bound),
    member("unit", &GateThatNoticed::unit),
};

template <>
inline constexpr auto record_members<NoticedMutation> = std::tuple{
    member("id", &NoticedMutation::id),
    member("what", &NoticedMutation::what),
    member("caught_by", &NoticedMutation::caught_by),
};

template <>
inline constexpr auto record_members<GatePower> = std::tuple{
    member("mutations", &GatePower::mutations),
    member("gates", &GatePower::gates),
    member("false_alarms_per_run", &GatePower::false_alarms_per_run),
};

namespace {

Number sum_of_levels(std::span<const GateSpec> gates) {
  double sum = 0.0;
  for (const GateSpec& gate : gates) {
    if (!gate.calibration || !gate.calibration->level) return std::nullopt;
    sum += *gate.calibration->level;
  }
  return sum;
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
  return json_from(power);
}

GatePower read_gate_power(const Json& report) {
  return record_from<GatePower>(value_at(report, "gate_power"));
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
