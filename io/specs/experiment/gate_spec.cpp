#include "io/specs/experiment/gate_spec.h"

#include <nlohmann/json.hpp>
#include <set>

#include "io/json/schema.h"
#include "io/json/values.h"

namespace sturm {

namespace {

GateKind kind_in_file(const Json& word) {
  if (const GateKindEntry* entry = gate_kind_in_file(word.get<std::string>())) return entry->kind;
  throw std::logic_error("the schema of gates allows a comparison that is not known");
}

}  // namespace

Json calibration_json(const std::optional<GateCalibration>& calibration) {
  if (!calibration) return Json::object();
  const auto& [level, tolerance, noise] = *calibration;
  return {{"level", number_or_null(level)},
          {"tolerance", {{"value", tolerance.value}, {"reason", tolerance.reason}}},
          {"noise", {{"standard_deviation", number_or_null(noise.standard_deviation)}, {"source", noise.source}}}};
}

std::optional<GateCalibration> read_calibration(const Json& gate) {
  if (!gate.contains("level") || !gate.contains("tolerance") || !gate.contains("noise")) return std::nullopt;
  const Json &tolerance = gate["tolerance"], &noise = gate["noise"];
  return GateCalibration{number_or_none(gate["level"]),
                         {tolerance["value"].get<double>(), tolerance["reason"].get<std::string>()},
                         {number_or_none(noise["standard_deviation"]), noise["source"].get<std::string>()}};
}

void require_calibrated(const std::vector<GateSpec>& gates, const std::string& file) {
  for (std::size_t i = 0; i < gates.size(); ++i)
    if (!gates[i].calibration)
      (Source{file, ""} / "gates" / i)
          .fail(gates[i].id, "a gate with \"level\", \"tolerance\" and \"noise\": what its bound was calibrated on");
}

std::vector<GateSpec> read_gates(const Json& document, const std::string& file) {
  validate(document, "gates", file);
  std::vector<GateSpec> gates;
  std::set<std::string> ids;
  for (const Json& value : document["gates"]) {
    GateSpec gate;
    const Source where = Source{file, ""} / "gates" / gates.size();
    gate.id = value["id"].get<std::string>();
    if (!ids.insert(gate.id).second) (where / "id").fail(value["id"], "an id that no other gate has");
    gate.title = value["title"].get<std::string>();
    gate.statistic = value["statistic"].get<std::string>();
    gate.kind = kind_in_file(value["comparison"]);
    gate.bound = value["bound"].get<double>();
    gate.unit = value.value("unit", "");
    gate.reason = value["reason"].get<std::string>();
    gate.calibration = read_calibration(value);
    if (!gate.calibration && (value.contains("level") || value.contains("tolerance") || value.contains("noise")))
      where.fail(gate.id, "\"level\", \"tolerance\" and \"noise\" together, or none of them");
    if (gate.calibration && gate.calibration->noise.standard_deviation == 0.0 && gate.calibration->level != 0.0)
      (where / "level").fail(value["level"], "0, as the statistic does not depend on chance");
    gates.push_back(std::move(gate));
  }
  return gates;
}

}  // namespace sturm
