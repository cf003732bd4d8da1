#include "experiments/bench/section.h"

#include <nlohmann/json.hpp>

#include "experiments/bench/measurement.h"
#include "reports/page/bench_page.h"
#include "reports/sections/bench/bench_figures.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

class BenchRun : public SectionRun {
 public:
  BenchRun(const BenchSpec& spec, int threads) : spec_(spec), keys_(bench_keys(spec, threads)) {}

  std::string depends_on() const override { return keys_.run; }

  std::vector<std::string> folders() const override { return {"references"}; }

  void run(const SectionPlace& place, Json& report) override {
    const Stopwatch watch;
    report["bench"] = to_json(measured_bench(spec_, keys_, {place.folder, place.threads, place.quiet}));
    place.steps.add_seconds(watch.seconds());
  }

  std::vector<Figure> figures(const Json& report, const RunFolder&, const std::string& command) const override {
    std::vector<Figure> drawn;
    const BenchFindings found = bench_findings(report).value();
    for (const BenchViewResult& view : found.views)
      for (Figure& figure : bench_figures_of_experiment(view, command)) drawn.push_back(std::move(figure));
    return drawn;
  }

  Json sentence(const Json& report) const override { return bench_sentence(*bench_findings(report)); }

 private:
  const BenchSpec& spec_;
  BenchKeys keys_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_bench(const ExperimentSpec& spec, const RunOptions& options) {
  return spec.bench ? std::make_unique<BenchRun>(*spec.bench, options.threads) : nullptr;
}

}  // namespace sturm
