#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/text_answers.h"
#include "experiments/run/progress.h"
#include "experiments/stress/report.h"

namespace sturm {

int stress_command(const CommonOptions& options, const StressOptions& stress, const std::string& output) {
  require_answer_name(output, AnswerKind::Json);
  const std::uint64_t seed = options.seed.value_or(1);
  if (stress.replayed) {
    const stress::FreeFormLenses free_forms;
    const stress::CaseRun run = stress::run_case(seed, *stress.replayed, free_forms);
    write_result(stress::case_json(seed, *stress.replayed, run, free_forms), output);
    return run.outcomes.passed() ? 0 : 1;
  }
  Progress progress("stress", static_cast<double>(stress.cases), "cases", options.quiet);
  const stress::SuiteSummary summary =
      stress::run_suite({stress.cases, seed}, [&](double done) { progress.update(done); });
  if (!output.empty()) write_result(stress::report_of(summary), output);
  std::cout << stress::table_of(summary);
  return summary.passed() ? 0 : 1;
}

}  // namespace sturm
