#include "compare/findings/gate_power.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "compare/findings/judged_report.h"
#include "io/json/stored.h"
#include "io/json/values.h"

namespace sturm {

namespace {

/// Calls visit for every list of entries that may hold patches.
template <class Visit>
void for_each_list(Json& report, const Visit& visit) {
  for (const char* pointer : {"/ellipses/cases", "/psfs", "/images"}) {
    const Json::json_pointer place(pointer);
    if (report.contains(place) && report[place].is_array()) visit(report[place]);
  }
}

/// None where any gate does not state its level: then the sum would be too small.
std::optional<double> sum_of_levels(std::span<const GateSpec> gates) {
  double sum = 0.0;
  for (const GateSpec& gate : gates) {
    if (!gate.calibration || !gate.calibration->level) return std::nullopt;
    sum += *gate.calibration->level;
  }
  return sum;
}

}  // namespace

Json mutated_report(const Json& report, const std::string& mutation) {
  Json mutated = report;
  for_each_list(mutated, [&](Json& entries) {
    for (Json& entry : entries)
      if (const Json patch = value_at(value_at(entry, "mutated"), mutation); patch.is_object())
        entry.merge_patch(patch);
  });
  drop_mutated(mutated);
  return mutated;
}

void drop_mutated(Json& report) {
  for_each_list(report, [](Json& entries) {
    for (Json& entry : entries)
      if (entry.is_object()) entry.erase("mutated");
  });
}

Json gate_power(std::span<const GateSpec> gates, const Json& report, std::span<const MutationName> mutations,
                const Json& baseline, std::span<const FindingSection> sections) {
  const Json honest = evaluate_gates(gates, report, &baseline, sections);
  Json rows = Json::array();
  for (const MutationName& mutation : mutations) {
    const Json results = evaluate_gates(gates, mutated_report(report, mutation.id), &baseline, sections);
    Json caught_by = Json::array();
    for (std::size_t i = 0; i < gates.size(); ++i) {
      const Json &before = honest[i], &after = results[i];
      if (before["passed"].get<bool>() && !after["passed"].get<bool>())
        caught_by.push_back({{"gate", gates[i].id},
                             {"value", after["value"]},
                             {"honest_value", before["value"]},
                             {"bound", gates[i].bound},
                             {"unit", gates[i].unit}});
    }
    rows.push_back({{"id", mutation.id}, {"what", mutation.what}, {"caught_by", std::move(caught_by)}});
  }
  return {{"mutations", std::move(rows)},
          {"gates", gates.size()},
          {"false_alarms_per_run", number_or_null(sum_of_levels(gates))}};
}

}  // namespace sturm
