#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands.h"
#include "compare/findings/judged_report.h"
#include "compare/gates/gates.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/experiment/gate_spec.h"
#include "reports/text/junit.h"
#include "reports/text/markdown.h"

namespace sturm {

namespace {

/// The gates that a report was judged by, read back from it.
std::vector<GateSpec> gates_in(const Json& report, const std::string& file) {
  std::vector<GateSpec> gates;
  for (const Json& g : report.at("gates")) {
    const GateKindEntry* kind = gate_kind_in_report(g.at("kind").get<std::string>());
    if (!kind || !g.at("bound").is_number())
      throw InputError(file, "/gates/" + std::to_string(gates.size()), g.dump(), "a gate of known kind with a bound");
    gates.push_back({.id = g.at("id"),
                     .title = g.at("title"),
                     .statistic = g.at("statistic"),
                     .kind = kind->kind,
                     .bound = g.at("bound"),
                     .unit = g.at("unit"),
                     .reason = g.at("reason"),
                     .calibration = read_calibration(g)});
  }
  return gates;
}

/// Without a baseline at hand, what a report says about its own baseline gates stands.
void keep_stored_baseline_results(Json& results, const Json& report) {
  const std::string baseline(entry_of(GateKind::Baseline).report_word);
  for (Json& result : results)
    for (const Json& stored : report.at("gates"))
      if (result.at("kind") == baseline && stored.at("id") == result.at("id")) result = stored;
}

void print_results(const Json& results) {
  for (const Json& r : results) {
    const std::string value = r.at("value").is_number() ? r.at("value").dump() : "no value";
    std::printf("%s  %-36s %s %s (bound %s)\n", r.at("passed").get<bool>() ? "pass" : "FAIL",
                r.at("id").get<std::string>().c_str(), value.c_str(), r.at("unit").get<std::string>().c_str(),
                r.at("bound").dump().c_str());
  }
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
  for (const char* bulky :
       {"ellipses", "sin2", "psfs", "lens_study", "sampling_study", "sin2_study", "gate_power", "bench"})
    baseline.erase(bulky);
  return baseline;
}

}  // namespace

int gate_command(const GateOptions& options) {
  const Json report = load_json(options.report);
  validate(report, "report", options.report);
  const std::vector<GateSpec> gates =
      options.gates.empty() ? gates_in(report, options.report) : read_gates(load_json(options.gates), options.gates);
  const Json baseline = options.baseline.empty() ? Json(nullptr) : load_json(options.baseline);
  Json results = evaluate_gates(gates, report, baseline.is_null() ? nullptr : &baseline);
  if (baseline.is_null() && options.gates.empty()) keep_stored_baseline_results(results, report);
  const Json verdict = verdict_of(results);
  print_results(results);
  std::cout << verdict.at("sentence").get<std::string>() << "\n";
  if (!options.junit.empty()) write_file_atomically(options.junit, junit_xml(results, report.at("title")));
  if (!options.markdown.empty()) write_file_atomically(options.markdown, report_markdown(report, results, verdict));
  if (!options.new_baseline.empty()) write_file_atomically(options.new_baseline, baseline_of(report).dump(1) + "\n");
  return verdict.at("passed").get<bool>() ? 0 : 1;
}

}  // namespace sturm
