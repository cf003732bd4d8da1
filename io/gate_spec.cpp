#include "io/gate_spec.h"

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "io/schema.h"

namespace sturm {

namespace {
constexpr std::array<std::pair<Comparison, const char*>, 5> comparison_names = {{{Comparison::AtMost, "at_most"},
                                                                                 {Comparison::AtLeast, "at_least"},
                                                                                 {Comparison::Differs, "differs"},
                                                                                 {Comparison::Baseline, "baseline"},
                                                                                 {Comparison::MustFail, "must_fail"}}};

Comparison comparison_of(const Json& name) {
  for (const auto& [comparison, word] : comparison_names)
    if (name == word) return comparison;
  throw std::logic_error("the schema of gates allows a comparison that is not known");
}
}  // namespace

std::string to_string(Comparison comparison) {
  for (const auto& [known, word] : comparison_names)
    if (known == comparison) return word;
  throw std::logic_error("comparison without a name");
}

std::vector<GateSpec> read_gates(const Json& document, const std::string& file) {
  validate(document, "gates", file);
  std::vector<GateSpec> gates;
  std::set<std::string> ids;
  for (const Json& value : document["gates"]) {
    GateSpec gate;
    gate.id = value["id"].get<std::string>();
    if (!ids.insert(gate.id).second) (Source{file, ""} / "gates" / gates.size() / "id").fail(value["id"], "an id that no other gate has");
    gate.title = value["title"].get<std::string>();
    gate.statistic = value["statistic"].get<std::string>();
    gate.comparison = comparison_of(value["comparison"]);
    gate.bound = value["bound"].get<double>();
    gate.unit = value.value("unit", "");
    gate.reason = value["reason"].get<std::string>();
    gates.push_back(std::move(gate));
  }
  return gates;
}

}  // namespace sturm
