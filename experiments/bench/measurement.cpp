#include "experiments/bench/measurement.h"

#include <cstdio>

#include "compare/studies/bench/evaluation.h"
#include "experiments/bench/reference.h"
#include "experiments/run/progress.h"
#include "experiments/run/replicates.h"
#include "io/files/machine.h"
#include "io/files/sha256.h"
#include "io/json/manifest.h"
#include "stages/render_stage.h"

namespace sturm {

namespace {

std::string run_key(const BenchSpec& spec, const std::vector<std::string>& reference_keys, int threads) {
  std::string facts = spec_hash(*spec.resolved) + std::to_string(threads) + sha256_of_file("/proc/self/exe");
  for (std::size_t v = 0; v < spec.views.size(); ++v) {
    facts += reference_keys[v];
    for (const BenchSetting& setting : spec.views[v].settings) facts += spec_hash(*setting.render.resolved);
  }
  for (const std::string& file : spec.input_files) facts += sha256_of_file(file);
  return sha256(facts);
}

/// Rays that left the camera, over all parts of a render's counters (stereo pairs and predictions have them one level
/// down).
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

/// The layer that is measured of a method's pictures.
const char* layer_of(const std::string& method, const std::vector<BenchMethod>& methods) {
  for (const BenchMethod& m : methods)
    if (m.id == method && m.denoised) return "denoised";
  return "";
}

/// All settings of one view, once.
std::vector<BenchSample> measured_round(const BenchView& view, const std::vector<BenchMethod>& methods,
                                        const ReferenceImage& reference, std::uint64_t seed, int round,
                                        MeasuringProgress& progress) {
  std::vector<BenchSample> results;
  for (std::size_t i = 0; i < view.settings.size(); ++i) {
    RenderSpec spec = view.settings[i].render;
    spec.seed = replicate_seed(replicate_seed(seed, static_cast<int>(i) + 1), round);
    const double samples = planned_samples(view.settings[i]);
    const RenderOutput output = render_view(spec, [&](double fraction) { progress.update(fraction, samples); });
    results.push_back({rendering_seconds(output.seconds), camera_rays(output.counters),
                       reference.errors_of(output.image.layers.at(layer_of(view.settings[i].method, methods)))});
    progress.finish(samples);
  }
  return results;
}

/// The rounds of all views, in the order in which they are made: round by round.
std::vector<MeasuredView> measured(const BenchSpec& spec, const std::vector<BenchReference>& references,
                                   const RunFolder& folder, bool quiet) {
  std::vector<MeasuredView> views;
  double samples_of_round = 0.0;
  for (std::size_t v = 0; v < spec.views.size(); ++v) {
    MeasuredView view{spec.views[v].id, references[v].image.noise_floor(), {}};
    for (const BenchSetting& setting : spec.views[v].settings) {
      view.settings.push_back({setting.method, setting.render.samples_per_pixel, {}, setting.label});
      samples_of_round += planned_samples(setting);
    }
    views.push_back(std::move(view));
  }
  render_view(spec.views.front().settings.front().render,
              {});  // the first rendering of a process starts its threads; it does not count
  MeasuringProgress progress(samples_of_round * spec.rounds, quiet);
  for (int round = 0; round < spec.rounds; ++round)
    for (std::size_t v = 0; v < spec.views.size(); ++v) {
      const RunFolder::Part part = folder.part("round_" + std::to_string(round) + "_" + spec.views[v].id, [&] {
        return to_json(measured_round(spec.views[v], spec.methods, references[v].image,
                                      replicate_seed(spec.seed, static_cast<int>(v)), round, progress));
      });
      if (part.reused && !quiet)
        std::fprintf(stderr, "round %d of %s: taken from the interrupted run\n", round + 1, spec.views[v].id.c_str());
      const std::vector<BenchSample> samples = bench_samples_from(part.value);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        views[v].settings[i].rounds.push_back(samples[i]);
        if (part.reused) progress.finish(planned_samples(spec.views[v].settings[i]));
      }
    }
  return views;
}

BenchMachine machine_facts(const Machine& machine, int threads) {
  BenchMachine facts{.cpu = cpu_model(),
                     .cores = machine.cores,
                     .logical_processors = machine.logical_processors,
                     .threads = threads,
                     .memory_bytes = machine.memory_bytes};
  if (machine.load) facts.load_at_start = {machine.load->begin(), machine.load->end()};
  return facts;
}

}  // namespace

BenchKeys bench_keys(const BenchSpec& spec, int threads) {
  BenchKeys keys;
  for (const BenchView& view : spec.views) keys.references.push_back(reference_key(view, spec.seed));
  keys.run = run_key(spec, keys.references, threads);
  return keys;
}

BenchFindings measured_bench(const BenchSpec& spec, const BenchKeys& keys, const BenchPlace& place) {
  const Machine machine = this_machine();
  std::vector<BenchReference> references;
  for (std::size_t v = 0; v < spec.views.size(); ++v)
    references.push_back(
        bench_reference(spec.views[v], keys.references[v], spec.seed, place.folder.path(), place.quiet));
  const std::vector<MeasuredView> views = measured(spec, references, place.folder, place.quiet);

  BenchFindings found{.title = spec.title, .machine = machine_facts(machine, place.threads)};
  for (std::size_t v = 0; v < views.size(); ++v) {
    BenchViewResult view = evaluated(views[v], spec.methods, spec.levels);
    view.id = spec.views[v].id;
    view.title = spec.views[v].title;
    view.resolution = {references[v].image.mean().width, references[v].image.mean().height};
    view.reference = references[v].facts;
    found.views.push_back(std::move(view));
  }
  found.requirements = evaluated(spec.requirements, views);
  found.verdict = bench_verdict(found.requirements);
  return found;
}

}  // namespace sturm
