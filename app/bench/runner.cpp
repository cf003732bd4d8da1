#include "app/bench/runner.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/bench/reference.h"
#include "app/experiment/replicates.h"
#include "app/experiment/run_folder.h"
#include "app/progress.h"
#include "app/render_stage.h"
#include "app/stopwatch.h"
#include "compare/bench/evaluation.h"
#include "compare/bench/figures.h"
#include "compare/bench/report_html.h"
#include "io/atomic_file.h"
#include "io/machine.h"
#include "io/manifest.h"
#include "io/sha256.h"

namespace sturm {

namespace {

/// What a round's numbers depend on: everything, the program and the number of threads included.
std::string run_key(const BenchSpec& spec, const std::vector<std::string>& reference_keys, const RunOptions& options) {
  std::string facts = spec_hash(*spec.resolved) + std::to_string(options.threads) + sha256_of_file("/proc/self/exe");
  for (std::size_t v = 0; v < spec.views.size(); ++v) {
    facts += reference_keys[v];
    for (const BenchSetting& setting : spec.views[v].settings) facts += spec_hash(*setting.render.resolved);
  }
  for (const std::string& file : spec.input_files) facts += sha256_of_file(file);
  return sha256(facts);
}

/// Rays that left the camera, over all parts of a render's counters (stereo pairs and predictions have them one level down).
double camera_rays(const Json& counters) {
  double sum = 0.0;
  for (const auto& [key, value] : counters.items()) {
    if (value.is_object()) sum += camera_rays(value);
    if (key == "camera_rays" || key == "guided_rays") sum += value.get<double>();
  }
  return sum;
}

/// Loading the scene is no part of a method.
double rendering_seconds(const std::map<std::string, double>& seconds) {
  double sum = 0.0;
  for (const auto& [part, time] : seconds)
    if (part != "scene") sum += time;
  return sum;
}

double planned_samples(const BenchSetting& setting) {
  const RenderSpec& r = setting.render;
  return static_cast<double>(r.camera.width) * r.camera.height * static_cast<double>(r.samples_per_pixel);
}

/// Tells how far the whole measurement is while its parts are made or taken over.
class MeasuringProgress {
 public:
  MeasuringProgress(double samples, bool quiet) : samples_(samples), bar_("measuring", samples, "samples", quiet) {}

  void update(double fraction, double of_samples) { bar_.update((done_ + fraction * of_samples) / samples_); }
  void finish(double part_samples) {
    done_ += part_samples;
    bar_.update(done_ / samples_);
  }

 private:
  double samples_, done_ = 0.0;
  Progress bar_;
};

/// All settings of one view, once.
Json measured_round(const BenchView& view, const ReferenceImage& reference, std::uint64_t seed, int round, MeasuringProgress& progress) {
  Json results = Json::array();
  for (std::size_t i = 0; i < view.settings.size(); ++i) {
    RenderSpec spec = view.settings[i].render;
    spec.seed = replicate_seed(replicate_seed(seed, static_cast<int>(i) + 1), round);
    const double samples = planned_samples(view.settings[i]);
    const RenderOutput output = render_view(spec, [&](double fraction) { progress.update(fraction, samples); });
    results.push_back({{"seconds", rendering_seconds(output.seconds)},
                       {"samples", camera_rays(output.counters)},
                       {"errors", picture_errors_json(reference.errors_of(output.image.layers.at("")))}});
    progress.finish(samples);
  }
  return results;
}

/// The rounds of all views, in the order in which they are made: round by round.
std::vector<MeasuredView> measured(const BenchSpec& spec, const std::vector<BenchReference>& references, const RunFolder& folder,
                                   bool quiet) {
  std::vector<MeasuredView> views;
  double samples_of_round = 0.0;
  for (std::size_t v = 0; v < spec.views.size(); ++v) {
    MeasuredView view{spec.views[v].id, references[v].image.noise_floor(), {}};
    for (const BenchSetting& setting : spec.views[v].settings) {
      view.settings.push_back({setting.method, setting.render.samples_per_pixel, {}});
      samples_of_round += planned_samples(setting);
    }
    views.push_back(std::move(view));
  }
  render_view(spec.views.front().settings.front().render, {});  // the first rendering of a process starts its threads; it does not count
  MeasuringProgress progress(samples_of_round * spec.rounds, quiet);
  for (int round = 0; round < spec.rounds; ++round)
    for (std::size_t v = 0; v < spec.views.size(); ++v) {
      const RunFolder::Part part = folder.part("round_" + std::to_string(round) + "_" + spec.views[v].id, [&] {
        return measured_round(spec.views[v], references[v].image, replicate_seed(spec.seed, static_cast<int>(v)), round, progress);
      });
      if (part.reused && !quiet)
        std::fprintf(stderr, "round %d of %s: taken from the interrupted run\n", round + 1, spec.views[v].id.c_str());
      for (std::size_t i = 0; i < part.value.size(); ++i) {
        const Json& sample = part.value[i];
        views[v].settings[i].rounds.push_back(
            {sample.at("seconds").get<double>(), sample.at("samples").get<double>(), picture_errors_from(sample.at("errors"))});
        if (part.reused) progress.finish(planned_samples(spec.views[v].settings[i]));
      }
    }
  return views;
}

Json machine_json(const Machine& machine, int threads) {
  return {{"cpu", cpu_model()},
          {"cores", machine.cores ? Json(*machine.cores) : Json(nullptr)},
          {"logical_processors", machine.logical_processors},
          {"threads", threads},
          {"memory_bytes", machine.memory_bytes ? Json(*machine.memory_bytes) : Json(nullptr)},
          {"load_at_start", machine.load ? Json(*machine.load) : Json(nullptr)}};
}

}  // namespace

BenchOutcome run_bench(const BenchSpec& spec, const std::string& bench_file, const RunOptions& options) {
  const Stopwatch watch;
  const Machine machine = this_machine();
  RunFacts facts{options.threads, spec.seed, utc_now(), {}, spec.input_files};
  if (bench_file != "-") facts.input_files.insert(facts.input_files.begin(), bench_file);
  // Loads every scene: what is wrong with one shows before the folder is touched.
  std::vector<std::string> reference_keys;
  for (const BenchView& view : spec.views) reference_keys.push_back(reference_key(view, spec.seed));
  const RunFolder folder(options.folder, run_key(spec, reference_keys, options), options.resume,
                         {{"bench.json", "bench.html"}, {"references", "figures"}});

  std::vector<BenchReference> references;
  for (std::size_t v = 0; v < spec.views.size(); ++v)
    references.push_back(bench_reference(spec.views[v], reference_keys[v], spec.seed, folder.path(), options.quiet));
  const std::vector<MeasuredView> views = measured(spec, references, folder, options.quiet);

  const std::string command = "sturm bench " + bench_file;
  Json report = {{"format", "sturm.bench_report/1"},
                 {"title", spec.title},
                 {"command", command},
                 {"spec", *spec.resolved},
                 {"machine", machine_json(machine, options.threads)},
                 {"views", Json::array()},
                 {"figures", Json::array()}};
  for (std::size_t v = 0; v < views.size(); ++v) {
    Json view = evaluated(views[v], spec.methods, spec.levels);
    view["id"] = spec.views[v].id;
    view["title"] = spec.views[v].title;
    view["resolution"] = {references[v].image.mean().width, references[v].image.mean().height};
    view["reference"] = references[v].facts;
    for (const Figure& figure : bench_figures(view, command)) {
      write_file_atomically(folder.path() / figure_file(figure.id), figure.svg);
      report["figures"].push_back(figure_json(figure));
    }
    report["views"].push_back(std::move(view));
  }
  report["requirements"] = evaluated(spec.requirements, views);
  report["verdict"] = bench_verdict(report["requirements"]);
  facts.seconds["total"] = watch.seconds();
  report["provenance"] = provenance(facts, *spec.resolved);
  write_file_atomically(folder.path() / "bench.html", bench_report_html(report, folder.path()));
  write_file_atomically(folder.path() / "bench.json", report.dump(1) + "\n");
  return {report["verdict"].at("passed"), bench_report_text(report), folder.path() / "bench.html"};
}

}  // namespace sturm
