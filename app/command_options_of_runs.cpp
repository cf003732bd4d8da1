#include "app/command_options.h"

namespace sturm {

void CommandLine::add_run() {
  auto* run = app.add_subcommand("run", "run an experiment and write its report");
  add_common_options(*run, common, "experiment (sturm.experiment/1)", "experiment");
  run->add_option("-o,--out", folder, "folder of the report (default: reports/runs/NAME)");
  run->add_flag("--resume", resume, "take over what an interrupted run has finished");
  run->callback([this] { action = [this] { return run_command(common, folder, resume); }; });
}

void CommandLine::add_bench() {
  auto* bench = app.add_subcommand("bench", "run time against error: methods and settings over views");
  add_common_options(*bench, common, "benchmark (sturm.bench/1)", "bench");
  bench->add_option("-o,--out", folder, "folder of the report (default: reports/runs/NAME)");
  bench->add_flag("--resume", resume, "take over the rounds that an interrupted run has finished");
  bench->callback([this] { action = [this] { return bench_command(common, folder, resume); }; });
}

void CommandLine::add_compare_runs() {
  auto* c =
      app.add_subcommand("compare-runs", "what has changed between two runs of an experiment, beyond its uncertainty");
  c->add_option("before", compare_runs.before, "run folder or report.json")->required();
  c->add_option("after", compare_runs.after, "run folder or report.json")->required();
  c->add_option("--json", compare_runs.json_file,
                "write the comparison as JSON (- is standard output, instead of the table)");
  c->add_option("--level", compare_runs.level, "chance of any false alarm in the whole comparison")
      ->check(CLI::Range(1e-9, 0.5))
      ->capture_default_str();
  c->add_flag("--gate", compare_runs.gate, "exit status 1 if something got worse");
  c->callback([this] { action = [this] { return compare_runs_command(compare_runs); }; });
}

void CommandLine::add_gate() {
  auto* g = app.add_subcommand("gate", "evaluate gates on a stored report");
  g->add_option("report", gate.report, "report.json")->required();
  g->add_option("--gates", gate.gates, "gates file (default: the gates that the report was judged by)");
  g->add_option("--baseline", gate.baseline, "baseline to compare with");
  g->add_option("--junit", gate.junit, "write the results as JUnit XML");
  g->add_option("--markdown", gate.markdown, "write a short summary in Markdown, for a pull request");
  g->add_option("--write-baseline", gate.new_baseline, "store this report's numbers as a new baseline");
  g->callback([this] { action = [this] { return gate_command(gate); }; });
}

void CommandLine::add_report() {
  auto* r = app.add_subcommand("report", "draw the page of a stored run again");
  r->add_option("run", folder, "run folder, or the report.json or bench.json in it")->required();
  r->add_option("-o,--output", output, "file for the page (default: report.html or bench.html beside the report)");
  r->callback([this] { action = [this] { return report_command(folder, output); }; });
}

}  // namespace sturm
