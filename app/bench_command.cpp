#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "experiments/bench/runner.h"

namespace sturm {

int bench_command(const CommonOptions& options, const std::string& folder, bool resume) {
  const Json document = load_configuration(options);
  if (options.print_config) return print_configuration(document, options.file, "");
  const BenchSpec spec = read_bench(document, options.file);
  RunOptions run;
  run.folder =
      !folder.empty()
          ? folder
          : "reports/runs/" + (options.file == "-" ? "bench" : std::filesystem::path(options.file).stem().string());
  run.threads = thread_count(options);
  run.resume = resume;
  run.quiet = options.quiet;
  const BenchOutcome outcome = run_bench(spec, options.file, run);
  std::cout << outcome.text << "Report: " << outcome.report_html.string() << "\n";
  return outcome.passed ? 0 : 1;
}

}  // namespace sturm
