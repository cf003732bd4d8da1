// What adaptive sampling gains over the same number of samples for every pixel, on a view that is mostly in focus.
//
// Both kinds of picture are rendered in turn, with other seeds each time. Both are unbiased, so the scatter between the
// pictures of a kind is its error: no reference picture takes part whose own noise could speak for one side. relative
// MSE: the sample variance between pictures over mean² + 0.01, averaged over pixels and channels, the mean being that
// of all pictures. Exit status 1 if the gain that is asked for is missed.
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/timing.h"
#include "io/json/json.h"
#include "io/specs/render_spec.h"
#include "pathtrace/scene/scene_import.h"
#include "stages/render_stage.h"
#include "support/source_folder.h"

namespace sturm::bench {
namespace {

struct Options {
  std::string view = STURM_SOURCE_DIR "/configs/views/near_screen.json";
  int threads = tbb::info::default_concurrency();
  int pictures = 6;  ///< of each kind
  int width = 240, height = 160;
  double relative_error = 0.02;
  int uniform_samples = 128;
  double require_gain = 0.0;
};

/// Pictures of one kind and how long they took.
struct Kind {
  std::string name;
  RenderSettings settings;
  std::vector<Image> pictures;
  std::vector<double> times, samples;

  double mean(std::size_t i) const {
    double sum = 0.0;
    for (const Image& p : pictures) sum += static_cast<double>(p.pixels[i]);
    return sum / static_cast<double>(pictures.size());
  }
  double variance(std::size_t i) const {
    const double m = mean(i);
    double sum = 0.0;
    for (const Image& p : pictures)
      sum += (static_cast<double>(p.pixels[i]) - m) * (static_cast<double>(p.pixels[i]) - m);
    return sum / static_cast<double>(pictures.size() - 1);
  }
};

void render_one(const Scene& scene, const RenderSpec& spec, const ViewPlan& plan, Kind& kind, std::uint64_t seed) {
  kind.settings.seed = seed;
  RenderResult result;
  kind.times.push_back(seconds([&] { result = path_trace_view(scene, spec, spec.eye, 0.0, kind.settings, plan); }));
  const double pixels = static_cast<double>(spec.camera.width) * spec.camera.height;
  kind.samples.push_back(static_cast<double>(result.passes.samples_spent) / pixels);
  kind.pictures.push_back(std::move(result.radiance));
}

double relative_mse(const Kind& kind, const Kind& other) {
  const std::size_t values = kind.pictures.front().pixels.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < values; ++i) {
    const double mean = 0.5 * (kind.mean(i) + other.mean(i));
    sum += kind.variance(i) / (mean * mean + 0.01);
  }
  return sum / static_cast<double>(values);
}

/// Prints a row; returns relative MSE times seconds.
double print_row(const Kind& kind, const Kind& other) {
  const double error = relative_mse(kind, other), time = median(kind.times);
  std::printf("%-34s %10.1f %9.3f %12.3e %14.3e\n", kind.name.c_str(), median(kind.samples), time, error, error * time);
  return error * time;
}

int run(const Options& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  Json document = load_json(options.view);
  document["camera"]["resolution"] = {options.width, options.height};
  const RenderSpec spec = read_render_spec(document, options.view);
  SceneDescription description = build_scene(spec.scene);
  const RenderPlan plan = plan_render(spec, description);
  const Scene scene(description);
  RenderSettings common;
  common.max_bounces = spec.max_bounces;
  common.guide_emitters = spec.guide_emitters;
  Kind uniform{"uniform, " + std::to_string(options.uniform_samples) + " samples per pixel", common, {}, {}, {}};
  uniform.settings.samples_per_pixel = options.uniform_samples;
  Kind adaptive{"adaptive, relative error " + std::to_string(options.relative_error).substr(0, 6), common, {}, {}, {}};
  adaptive.settings.samples_per_pixel = static_cast<int>(spec.samples_per_pixel);
  adaptive.settings.relative_error = options.relative_error;
  adaptive.settings.adaptive = spec.adaptive.value_or(AdaptiveSpec());
  for (int i = 0; i < options.pictures; ++i) {
    render_one(scene, spec, plan.right, uniform, 1000 + static_cast<std::uint64_t>(i));
    render_one(scene, spec, plan.right, adaptive, 2000 + static_cast<std::uint64_t>(i));
  }
  std::printf("%s at %d x %d, %d threads, %d interleaved pictures of each kind, medians\n", options.view.c_str(),
              options.width, options.height, options.threads, options.pictures);
  std::printf("%-34s %10s %9s %12s %14s\n", "", "samples/px", "seconds", "relative MSE", "relMSE x s");
  const double gain = print_row(uniform, adaptive) / print_row(adaptive, uniform);
  std::printf("gain: %.2f times less time for the same error (time taken to go as 1/error)\n", gain);
  return gain >= options.require_gain ? 0 : 1;
}

}  // namespace
}  // namespace sturm::bench

int main(int argc, char** argv) {
  sturm::bench::Options options;
  CLI::App app("Adaptive against uniform sampling");
  app.add_option("--view", options.view, "sturm.render/1 document");
  app.add_option("--threads", options.threads, "worker threads")->check(CLI::PositiveNumber);
  app.add_option("--pictures", options.pictures, "interleaved pictures of each kind")->check(CLI::Range(2, 1000));
  app.add_option("--width", options.width, "pixels")->check(CLI::PositiveNumber);
  app.add_option("--height", options.height, "pixels")->check(CLI::PositiveNumber);
  app.add_option("--relative-error", options.relative_error, "of the adaptive pictures")->check(CLI::PositiveNumber);
  app.add_option("--uniform-samples", options.uniform_samples, "per pixel")->check(CLI::PositiveNumber);
  app.add_option("--require-gain", options.require_gain, "least ratio of times for the same error");
  CLI11_PARSE(app, argc, argv);
  try {
    return sturm::bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_adaptive: %s\n", error.what());
    return 3;
  }
}
