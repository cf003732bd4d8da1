#include "experiments/runner.h"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/findings/gate_power.h"
#include "compare/findings/gate_statistics.h"
#include "compare/gates/gates.h"
#include "compare/gates/verdict.h"
#include "experiments/figures/figures.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "io/specs/experiment/gate_spec.h"
#include "reports/page/run_page.h"
#include "reports/text/ellipses_csv.h"
#include "reports/text/junit.h"
#include "reports/text/markdown.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

/// A section that the experiment asks for.
struct Wanted {
  const ExperimentSection& section;
  std::unique_ptr<SectionRun> run;
};

std::vector<Wanted> wanted_sections(std::span<const ExperimentSection> sections, const ExperimentSpec& spec,
                                    const RunOptions& options) {
  std::vector<Wanted> wanted;
  for (const ExperimentSection& section : sections)
    if (std::unique_ptr<SectionRun> run = section.prepared(spec, options)) wanted.push_back({section, std::move(run)});
  return wanted;
}

/// What a finished step depends on: the resolved spec, the program itself, and what the sections say.
std::string run_key(const ExperimentSpec& spec, const std::vector<Wanted>& wanted) {
  std::string facts = spec_hash(*spec.resolved) + sha256_of_file("/proc/self/exe");
  for (const Wanted& w : wanted) facts += w.run->depends_on();
  return sha256(facts);
}

/// Files and folders of a run; report.json, which appears last, first. Tables of an earlier run of another experiment
/// in the same folder go away, too.
RunFolder::Layout layout_of(std::span<const ExperimentSection> sections, const std::vector<Wanted>& wanted) {
  RunFolder::Layout layout{{"report.json", "report.html", "ellipses.csv", "junit.xml", "summary.md"}, {"figures"}};
  for (const ExperimentSection& section : sections)
    if (section.table) layout.reports.push_back(section.table);
  for (const Wanted& w : wanted)
    for (const std::string& folder : w.run->folders()) layout.folders.push_back(folder);
  return layout;
}

/// A benchmark's own requirements count as one gate more.
std::vector<GateSpec> gates_of(const ExperimentSpec& spec) {
  std::vector<GateSpec> gates;
  if (!spec.gates.empty()) gates = read_gates(load_json(spec.gates.string()), spec.gates.string());
  if (spec.bench && !spec.bench->requirements.empty())
    gates.push_back({"bench_requirements", "The benchmark's own requirements hold", "bench/broken_requirements",
                     GateKind::AtMost, 0.0, "", "Each has its own bound and reason in the benchmark."});
  return gates;
}

/// Writes the pictures into the run folder; the report's list of them.
Json written(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  Json list = Json::array();
  for (const Figure& figure : figures) {
    write_file_atomically(folder / figure_file(figure.id), figure.svg);
    list.push_back(figure_json(figure));
  }
  return list;
}

/// Of the report that the experiment names as its baseline, if there is one yet.
std::optional<Statistics> baseline_statistics(const ExperimentSpec& spec, const RunTables& tables) {
  if (!spec.baseline || !std::filesystem::exists(*spec.baseline)) return std::nullopt;
  const Json baseline = load_json(spec.baseline->string());
  return baseline.is_null() ? std::nullopt : std::optional(statistics_of(baseline, tables.findings));
}

/// What the report would say in numbers with each of the mutations: those that the experiment asks for, in all
/// sections, and each section's own.
std::vector<MutatedStatistics> mutated_statistics(std::span<const Mutation> mutations, const RunTables& tables,
                                                  const std::vector<Wanted>& wanted, const Json& report) {
  std::vector<MutatedStatistics> result;
  for (const Mutation& mutation : mutations) {
    Json mutated = report;
    for (const Wanted& w : wanted) w.run->mutate(mutation.id, mutated);
    result.push_back({mutation.id, mutation.what, statistics_of(mutated, tables.findings)});
  }
  for (const Wanted& w : wanted)
    for (const OwnMutation& mutation : w.run->own_mutations()) {
      Json mutated = report;
      w.run->mutate(mutation.id, mutated);
      result.push_back({mutation.id, mutation.what, statistics_of(mutated, tables.findings)});
    }
  return result;
}

struct Judgement {
  std::vector<GateResult> gates;
  Verdict verdict;
};

/// Gates, their power to see the mutations, and the verdict with its sentences; also entered into the report.
Judgement judge(const ExperimentSpec& spec, const std::vector<GateSpec>& gates, std::span<const Mutation> mutations,
                const RunTables& tables, const std::vector<Wanted>& wanted, Json& report) {
  const std::optional<Statistics> baseline = baseline_statistics(spec, tables);
  const Statistics* before = baseline ? &*baseline : nullptr;
  if (const auto mutated = mutated_statistics(mutations, tables, wanted, report); !mutated.empty())
    report["gate_power"] = to_json(gate_power(gates, statistics_of(report, tables.findings), mutated, before));
  Judgement judgement;
  judgement.gates = evaluate_gates(gates, statistics_of(report, tables.findings), before);
  judgement.verdict = verdict_of(judgement.gates);
  report["gates"] = to_json(judgement.gates);
  for (const ExperimentSection& section : tables.runs)
    if (section.sentence_key) judgement.verdict.findings[section.sentence_key] = std::nullopt;
  for (const Wanted& w : wanted)
    if (w.section.sentence_key)
      if (const Json sentence = w.run->sentence(report); sentence.is_string())
        judgement.verdict.findings[w.section.sentence_key] = sentence.get<std::string>();
  report["verdict"] = to_json(judgement.verdict);
  return judgement;
}

/// The texts and the page beside report.json, which is written last.
void write_reports(const Json& report, const Judgement& judgement, double seconds, const std::filesystem::path& folder,
                   std::span<const ReportSection> page) {
  const std::string title = report.at("title");
  write_file_atomically(folder / "ellipses.csv", ellipses_csv(read_ellipses(report).cases));
  write_file_atomically(folder / "junit.xml", junit_xml(judgement.gates, title, seconds));
  write_file_atomically(folder / "summary.md", report_markdown(report, judgement.gates, judgement.verdict));
  write_file_atomically(folder / "report.html", render_report_html(report, folder, page));
  write_file_atomically(folder / "report.json", json_text(report, 1));
}

RunOutcome outcome_of(const Verdict& verdict, const std::filesystem::path& folder,
                      std::span<const ExperimentSection> sections) {
  RunOutcome outcome{!verdict.has_failed(), verdict.sentence, {}, folder / "report.html"};
  for (const ExperimentSection& section : sections)
    if (section.sentence_key)
      if (std::string sentence = verdict.finding(section.sentence_key); !sentence.empty())
        outcome.findings.push_back(std::move(sentence));
  return outcome;
}

}  // namespace

RunOutcome run_experiment(const ExperimentSpec& spec, const std::string& experiment_file, const RunOptions& options,
                          const RunTables& tables) {
  const Stopwatch watch;
  const std::string started = utc_now();
  std::vector<std::string> inputs = spec.input_files;
  if (experiment_file != "-") inputs.insert(inputs.begin(), experiment_file);

  // Everything that can be wrong with the input shows before the output folder is touched.
  const std::vector<GateSpec> gates = gates_of(spec);
  const std::vector<Wanted> wanted = wanted_sections(tables.runs, spec, options);
  std::vector<Figure> figures = drawn_figures(spec.figures);

  const RunFolder folder(options.folder, run_key(spec, wanted), options.resume, layout_of(tables.runs, wanted));
  Steps steps(folder, options.quiet);
  const std::vector<Mutation> mutations = mutations_named(spec.mutations);
  const std::string command = "sturm run " + std::filesystem::path(experiment_file).filename().string();
  std::map<std::string, double> seconds;
  Json report = {{"format", "sturm.report/1"},
                 {"title", spec.title},
                 {"spec", *spec.resolved},
                 {"psfs", Json::array()},
                 {"images", Json::array()}};
  for (const Wanted& w : wanted) {
    w.run->run({folder, steps, mutations, options.threads, options.quiet}, report);
    if (const double spent = steps.lap(); spent > 0.0) seconds[w.section.name] = spent;
    for (Figure& figure : w.run->figures(report, folder, command)) figures.push_back(std::move(figure));
  }
  const Judgement judgement = judge(spec, gates, mutations, tables, wanted, report);
  seconds["total"] = watch.seconds();
  report["provenance"] = provenance({options.threads, spec.seed, started, seconds, inputs}, *spec.resolved);
  if (!figures.empty()) report["figures"] = written(figures, folder.path());
  write_reports(report, judgement, seconds["total"], folder.path(), tables.page);
  return outcome_of(judgement.verdict, folder.path(), tables.runs);
}

}  // namespace sturm
