#include "compare/gates/gate_result.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Json json_of(const GateResult& r) {
  Json json = {{"id", r.id},
               {"title", r.title},
               {"kind", r.kind ? Json(entry_of(*r.kind).report_word) : Json(nullptr)},
               {"passed", r.passed ? Json(*r.passed) : Json(nullptr)},
               {"statistic", r.statistic},
               {"value", number_or_null(r.value)},
               {"uncertainty", number_or_null(r.uncertainty)},
               {"bound", number_or_null(r.bound)},
               {"unit", r.unit},
               {"cases", count_or_null(r.cases)},
               {"worst_case", r.worst_case},
               {"reason", r.reason}};
  json.update(calibration_json(r.calibration));
  return json;
}

std::optional<GateCalibration> calibration_from(const Json& json) {
  const Number tolerance = number_at(json, "tolerance/value");
  if (!tolerance || !value_at(json, "noise").is_object()) return std::nullopt;
  return GateCalibration{.level = number_at(json, "level"),
                         .tolerance = {*tolerance, text_at(json, "tolerance/reason")},
                         .noise = {number_at(json, "noise/standard_deviation"), text_at(json, "noise/source")}};
}

GateResult result_from(const Json& json) {
  const GateKindEntry* kind = gate_kind_in_report(text_at(json, "kind"));
  return {.id = text_at(json, "id"),
          .title = text_at(json, "title"),
          .kind = kind ? std::optional(kind->kind) : std::nullopt,
          .passed = boolean_at(json, "passed"),
          .statistic = text_at(json, "statistic"),
          .value = number_at(json, "value"),
          .uncertainty = number_at(json, "uncertainty"),
          .bound = number_at(json, "bound"),
          .unit = text_at(json, "unit"),
          .cases = count_at(json, "cases"),
          .worst_case = text_at(json, "worst_case"),
          .reason = text_at(json, "reason"),
          .calibration = calibration_from(json)};
}

}  // namespace

Json to_json(const std::vector<GateResult>& results) {
  Json list = Json::array();
  for (const GateResult& result : results) list.push_back(json_of(result));
  return list;
}

std::vector<GateResult> read_gate_results(const Json& report) {
  std::vector<GateResult> results;
  for (const Json& entry : array_at(report, "gates")) results.push_back(result_from(entry));
  return results;
}

std::optional<GateSpec> gate_of(const GateResult& result) {
  if (!result.kind || !result.bound) return std::nullopt;
  return GateSpec{.id = result.id,
                  .title = result.title,
                  .statistic = result.statistic,
                  .kind = *result.kind,
                  .bound = *result.bound,
                  .unit = result.unit,
                  .reason = result.reason,
                  .calibration = result.calibration};
}

}  // namespace sturm
