#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/compare_suite.h"
#include "app/gate_lines.h"
#include "compare/gates/verdict.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "reports/text/junit.h"
#include "reports/text/markdown.h"

namespace sturm {

int compare_suite_command(const CompareOptions& options) {
  if (!options.json_file.empty() || !options.maps_folder.empty() || !options.noise.empty() || !options.edge.empty() ||
      options.psf || options.regions)
    throw InputError("", "--suite", "an option for two pictures",
                     "none of --json, --maps, --noise, --edge, --psf and --regions");
  const std::vector<GateResult> results = judge_suite(suite_pairs(options), options.beyond_noise);
  const Verdict verdict = verdict_of(results);
  std::cout << gate_lines(results) << verdict.sentence << "\n";
  const std::filesystem::path folder = std::filesystem::path(options.suite) / "";
  const std::string title = folder.parent_path().filename().string();
  if (!options.junit.empty()) write_file_atomically(options.junit, junit_xml(results, title));
  if (!options.markdown.empty()) write_file_atomically(options.markdown, gates_markdown(title, results, verdict));
  return verdict.has_passed() ? 0 : 1;
}

}  // namespace sturm
