#include "experiments/bench/runner.h"

#include <nlohmann/json.hpp>

#include "experiments/bench/measurement.h"
#include "io/files/atomic_file.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "reports/page/bench_page.h"
#include "reports/sections/bench/bench_figures.h"
#include "stages/stopwatch.h"

namespace sturm {

BenchOutcome run_bench(const BenchSpec& spec, const std::string& bench_file, const RunOptions& options) {
  const Stopwatch watch;
  RunFacts facts{options.threads, spec.seed, utc_now(), {}, spec.input_files};
  if (bench_file != "-") facts.input_files.insert(facts.input_files.begin(), bench_file);
  const BenchKeys keys = bench_keys(spec, options.threads);
  const RunFolder folder(options.folder, keys.run, options.resume,
                         {{"bench.json", "bench.html"}, {"references", "figures"}});

  const std::string command = "sturm bench " + bench_file;
  const BenchFindings found = measured_bench(spec, keys, {folder, options.threads, options.quiet});
  Json report = to_json(found);
  report["format"] = "sturm.bench_report/1";
  report["command"] = command;
  report["spec"] = *spec.resolved;
  report["figures"] = Json::array();
  for (const BenchViewResult& view : found.views)
    for (const Figure& figure : bench_figures(view, command)) {
      write_file_atomically(folder.path() / figure_file(figure.id), figure.svg);
      report["figures"].push_back(figure_json(figure));
    }
  facts.seconds["total"] = watch.seconds();
  report["provenance"] = provenance(facts, *spec.resolved);
  write_file_atomically(folder.path() / "bench.html", bench_report_html(report, folder.path()));
  write_file_atomically(folder.path() / "bench.json", json_text(report, 1) + "\n");
  return {found.verdict.passed, bench_report_text(found), folder.path() / "bench.html"};
}

}  // namespace sturm
