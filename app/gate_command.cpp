#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands.h"
#include "app/document_kinds.h"
#include "app/gate_lines.h"
#include "compare/findings/judged_report.h"
#include "compare/gates/gate_result.h"
#include "compare/gates/verdict.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/json_text.h"
#include "io/json/schema.h"
#include "io/specs/experiment/gate_spec.h"
#include "reports/text/junit.h"
#include "reports/text/markdown.h"

namespace sturm {

namespace {

/// The gates that a report was judged by, read back from it.
std::vector<GateSpec> gates_of(const std::vector<GateResult>& stored, const Json& report, const std::string& file) {
  std::vector<GateSpec> gates;
  for (const GateResult& result : stored) {
    const std::optional<GateSpec> gate = gate_of(result);
    const std::string place = "/gates/" + std::to_string(gates.size());
    if (!gate)
      throw InputError(file, place, report.at(Json::json_pointer(place)).dump(), "a gate of known kind with a bound");
    gates.push_back(*gate);
  }
  return gates;
}

/// Without a baseline at hand, what a report says about its own baseline gates stands.
void keep_stored_baseline_results(std::vector<GateResult>& results, const std::vector<GateResult>& stored) {
  for (GateResult& result : results)
    for (const GateResult& before : stored)
      if (result.kind == GateKind::Baseline && before.id == result.id) result = before;
}

/// A file below the current folder without the way there, which is nobody else's.
std::string short_name(const std::filesystem::path& file) {
  const std::filesystem::path within = file.lexically_relative(std::filesystem::current_path());
  return within.empty() || *within.begin() == ".." ? file.string() : within.string();
}

/// What later runs are held against: the numbers with their uncertainty, not every case.
Json baseline_of(const Json& report) {
  Json baseline = report;
  for (Json& input : baseline["provenance"]["inputs"]) input["file"] = short_name(input["file"].get<std::string>());
  for (const char* bulky : {"ellipses", "sin2", "psfs", "lens_study", "design_study", "sampling_study", "sin2_study",
                            "gate_power", "bench"})
    baseline.erase(bulky);
  return baseline;
}

}  // namespace

int gate_command(const GateOptions& options) {
  const Json report = load_json(options.report);
  require_kind(report, "report", options.report);
  validate(report, "report", options.report);
  const std::vector<GateResult> stored = read_gate_results(report);
  const std::vector<GateSpec> gates = options.gates.empty() ? gates_of(stored, report, options.report)
                                                            : read_gates(load_json(options.gates), options.gates);
  if (gates.empty()) throw InputError(options.report, "/gates", "no gates", "--gates FILE for a run without any");
  const Json baseline = options.baseline.empty() ? Json(nullptr) : load_json(options.baseline);
  std::vector<GateResult> results = evaluate_gates(gates, report, baseline.is_null() ? nullptr : &baseline);
  if (baseline.is_null() && options.gates.empty()) keep_stored_baseline_results(results, stored);
  const Verdict verdict = verdict_of(results);
  std::cout << gate_lines(results) << verdict.sentence << "\n";
  if (!options.junit.empty()) write_file_atomically(options.junit, junit_xml(results, report.at("title")));
  if (!options.markdown.empty()) write_file_atomically(options.markdown, report_markdown(report, results, verdict));
  if (!options.new_baseline.empty())
    write_file_atomically(options.new_baseline, json_text(baseline_of(report), 1) + "\n");
  return verdict.has_passed() ? 0 : 1;
}

}  // namespace sturm
