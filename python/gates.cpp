#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "compare/findings/judged_report.h"
#include "compare/gates/verdict.h"
#include "io/json/schema.h"
#include "io/specs/experiment/gate_spec.h"
#include "python/bindings.h"
#include "python/json_objects.h"

namespace sturm {

namespace {

py::tuple judged(const py::object& report, const py::object& gates, const py::object& baseline) {
  const GivenDocument given = given_document(report, ""), rules = given_document(gates, "");
  validate(given.document, "report", given.file);
  const std::vector<GateSpec> specs = read_gates(rules.document, rules.file);
  std::optional<Json> before;
  if (!baseline.is_none()) before = given_document(baseline, "").document;
  const std::vector<GateResult> results = evaluate_gates(specs, given.document, before ? &*before : nullptr);
  return py::make_tuple(verdict_of(results).has_passed(), object_from(to_json(results)));
}

}  // namespace

void bind_gates(py::module_& module) {
  using namespace pybind11::literals;
  module.def(
      "judge", &judged, "report"_a, "gates"_a, "baseline"_a = py::none(),
      "Judges a report (sturm.report/1) by gates (sturm.gates/1), each a dictionary or the path of a file: whether it\n"
      "has passed, and for each gate its value, bound and what decided.");
}

}  // namespace sturm
