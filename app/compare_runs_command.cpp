#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/findings/run_comparison.h"
#include "io/files/atomic_file.h"
#include "io/files/formatted_text.h"
#include "io/json/json_text.h"
#include "io/json/schema.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

/// A run's folder stands for the report in it.
std::string report_file(const std::string& run) {
  return std::filesystem::is_directory(run) ? (std::filesystem::path(run) / "report.json").string() : run;
}

std::string number_text(const std::optional<double>& number) {
  return number ? plain_number(*number, 6) : "none";
}

std::string word_for(const RunChange& change) {
  if (change.is_regression()) return "WORSE";
  if (change.kind == RunChange::Kind::New) return "new";
  if (change.kind == RunChange::Kind::Missing) return "gone";
  if (change.kind == RunChange::Kind::WithoutUncertainty) return "differs";
  return change.direction == RunChange::Direction::Better ? "better" : "changed";
}

const char* heading_of(const RunChange& change) {
  if (change.is_regression()) return "Worse:";
  switch (change.kind) {
    case RunChange::Kind::BeyondUncertainty:
      return "Changed beyond uncertainty:";
    case RunChange::Kind::WithoutUncertainty:
      return "No uncertainty is known of these, so chance or the machine may be all there is to it:";
    case RunChange::Kind::Verdict:
      return "Judged otherwise by gates:";
    case RunChange::Kind::New:
    case RunChange::Kind::Missing:
      return "In one of the runs only:";
  }
  return "";
}

/// Changes come in groups already.
void print_table(const RunComparison& comparison) {
  std::string heading;
  for (const RunChange& c : comparison.changes) {
    if (heading != heading_of(c)) std::printf("%s\n", (heading = heading_of(c)).c_str());
    const std::string z = c.z ? "  z = " + plain_number(*c.z, 3) : "";
    std::printf("  %-8s %s  %s -> %s%s\n", word_for(c).c_str(), c.name.c_str(), number_text(c.before).c_str(),
                number_text(c.after).c_str(), z.c_str());
  }
}

}  // namespace

int compare_runs_command(const CompareRunsOptions& options) {
  const std::string before_file = report_file(options.before), after_file = report_file(options.after);
  const Json before = load_json(before_file), after = load_json(after_file);
  validate(before, "report", before_file);
  validate(after, "report", after_file);
  const RunComparison comparison = compare_runs(before, after, options.level);
  const bool json_to_stdout = options.json_file == "-";
  if (!options.json_file.empty()) {
    const std::string text =
        json_text(run_comparison_json(comparison, before, before_file, after, after_file), 1) + "\n";
    if (json_to_stdout)
      std::cout << text;
    else
      write_file_atomically(options.json_file, text);
  }
  if (!json_to_stdout) {
    print_table(comparison);
    std::cout << sentence_of(comparison) << "\n";
    std::printf("Beyond uncertainty: |z| > %.3g, a false alarm in one comparison of %.3g.\n", comparison.threshold_z,
                1.0 / options.level);
    if (text_at(before, "title") != text_at(after, "title"))
      std::printf("The runs have different titles: are they the same experiment?\n");
  }
  return options.gate && comparison.regressions() > 0 ? 1 : 0;
}

}  // namespace sturm
