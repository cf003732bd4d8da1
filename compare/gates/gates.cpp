#include "compare/gates/gates.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

#include "compare/statistics/welch.h"

namespace sturm {

namespace {

using Statistics = std::map<std::string, Statistic>;

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

bool is_pattern(const std::string& name) {
  return name.ends_with("/*");
}

/// Names in `statistics` that a gate's statistic stands for.
std::set<std::string> names_for(const std::string& name, const Statistics& statistics) {
  if (!is_pattern(name)) return {name};
  const std::string prefix = name.substr(0, name.size() - 1);
  std::set<std::string> names;
  for (const auto& [candidate, unused] : statistics)
    if (candidate.starts_with(prefix)) names.insert(candidate);
  return names;
}

Statistic find(const std::string& name, const Statistics& statistics) {
  const auto found = statistics.find(name);
  if (found == statistics.end()) return {std::nullopt, std::nullopt, 0, "no statistic of this name: " + name};
  return found->second;
}

/// How far a statistic has fallen below its baseline, as a statistic of its own; negative where it has risen.
Statistic deviation(const std::string& name, const Statistics& now, const Statistics& before, const std::string& unit) {
  const Statistic a = find(name, now), b = find(name, before);
  if (!a.value) return a;
  if (!b.value) return {std::nullopt, std::nullopt, a.cases, a.worst_case + ": not in the baseline"};
  const std::string where = a.worst_case + ": " + short_number(*a.value) + ", baseline " + short_number(*b.value);
  const double difference = *b.value - *a.value;
  if (unit != "σ") return {difference, a.uncertainty, a.cases, where};
  const double error = std::hypot(a.uncertainty.value_or(0.0), b.uncertainty.value_or(0.0));
  if (!a.uncertainty || !b.uncertainty || !(error > 0.0))
    return {std::nullopt, std::nullopt, a.cases, where + ", no uncertainty"};
  return {
      welch_z(difference, {*a.uncertainty * *a.uncertainty, a.degrees}, {*b.uncertainty * *b.uncertainty, b.degrees}),
      std::nullopt, a.cases, where};
}

/// The statistic that decides a gate.
Statistic deciding(const GateSpec& gate, const Statistics& now, const Statistics* before) {
  const bool needs_baseline = gate.kind == GateKind::Baseline;
  if (needs_baseline && !before) return {std::nullopt, std::nullopt, 0, "no baseline"};
  std::set<std::string> names = names_for(gate.statistic, now);
  if (needs_baseline) names.merge(names_for(gate.statistic, *before));
  Statistic worst{std::nullopt, std::nullopt, 0, "no case"};
  const bool larger_is_worse = entry_of(gate.kind).passing == Relation::AtMost;
  std::uint64_t cases = 0;
  for (const std::string& name : names) {
    const Statistic s = needs_baseline ? deviation(name, now, *before, gate.unit) : find(name, now);
    if (!s.value || s.cases == 0) return {std::nullopt, std::nullopt, s.cases, s.worst_case};
    cases += s.cases;
    if (!worst.value || (larger_is_worse ? *s.value > *worst.value : *s.value < *worst.value)) worst = s;
  }
  worst.cases = cases;
  return worst;
}

}  // namespace

std::vector<GateResult> evaluate_gates(std::span<const GateSpec> gates, const Statistics& now,
                                       const Statistics* before) {
  std::vector<GateResult> results;
  for (const GateSpec& gate : gates) {
    const Statistic s = deciding(gate, now, before);
    results.push_back({.id = gate.id,
                       .title = gate.title,
                       .kind = gate.kind,
                       .passed = s.value && holds(entry_of(gate.kind).passing, *s.value, gate.bound),
                       .statistic = gate.statistic,
                       .value = s.value,
                       .uncertainty = s.uncertainty,
                       .bound = gate.bound,
                       .unit = gate.unit,
                       .cases = s.cases,
                       .worst_case = s.worst_case,
                       .reason = gate.reason,
                       .calibration = gate.calibration});
  }
  return results;
}

}  // namespace sturm
