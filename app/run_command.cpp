#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "experiments/runner.h"

namespace sturm {

int run_command(const CommonOptions& options, const std::string& folder, bool resume) {
  const Json document = load_configuration(options);
  if (options.print_config) return print_configuration(document, options.file, "");
  const ExperimentSpec spec = read_experiment(document, options.file);
  RunOptions run;
  run.folder =
      !folder.empty()
          ? folder
          : "reports/runs/" + (options.file == "-" ? "run" : std::filesystem::path(options.file).stem().string());
  run.threads = thread_count(options);
  run.resume = resume;
  run.quiet = options.quiet;
  const RunOutcome outcome = run_experiment(spec, options.file, run);
  std::cout << outcome.verdict << "\n";
  for (const std::string& finding : outcome.findings) std::cout << finding << "\n";
  std::cout << "Report: " << outcome.report_html.string() << "\n";
  return outcome.passed ? 0 : 1;
}

}  // namespace sturm
