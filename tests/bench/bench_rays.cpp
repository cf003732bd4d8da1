// How much of bare Embree's speed the camera and the path tracer keep, in the room of tests/reference/scene_plain.
//
//   camera: primary rays through the lens, made and traced by trace_camera_rays, against rtcIntersect1 on the very same
//   rays, made before. path:   samples per second of render() against a ceiling: every ray that such a run sends to
//   Embree (camera, bounce, shadow), recorded
//           before in that order, traced bare by rtcIntersect1 and rtcOccluded1.
//
// Both sides use the same threads and are timed in turn, A B A B; the ratio is the median over the pairs, so a machine
// that is busy with something else disturbs both alike. Exit status 1 if a required ratio is missed.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_reduce.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/ray_recorder.h"
#include "bench/timing.h"
#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/film/render.h"
#include "pathtrace/scene/embree_rays.h"
#include "support/scene_plain.h"

namespace sturm::bench {
namespace {

struct Options {
  int threads = tbb::info::default_concurrency();
  int repetitions = 7;
  int samples = 64;  ///< per pixel
  double require_camera = 0.0, require_path = 0.0;
  bool json = false;
};

/// One comparison: `ours` and `bare` in units per second.
struct Result {
  std::string name, unit;
  double ours, bare, ratio, required;

  bool passed() const { return ratio >= required; }
};

/// `units` are done by one call of either function.
Result compare(const Options& options, const std::string& name, const std::string& unit, double units, double required,
               const std::function<void()>& ours, const std::function<void()>& bare) {
  std::vector<double> our_times, bare_times, ratios;
  ours();
  bare();
  for (int i = 0; i < options.repetitions; ++i) {
    our_times.push_back(seconds(ours));
    bare_times.push_back(seconds(bare));
    ratios.push_back(bare_times.back() / our_times.back());
  }
  return {name, unit, units / median(our_times), units / median(bare_times), median(ratios), required};
}

/// Runs count_hits(first, last) over [0, n) on all threads and adds up, so that no compiler may leave the work out.
template <class Function>
std::size_t in_parallel(std::size_t n, std::size_t grain, const Function& count_hits) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, n, grain), std::size_t{0},
      [&](const auto& range, std::size_t sum) { return sum + count_hits(range.begin(), range.end()); }, std::plus<>());
}

std::size_t trace_bare(RTCScene scene, const std::vector<RecordedRay>& rays) {
  return in_parallel(rays.size(), 4096, [&](std::size_t first, std::size_t last) {
    std::size_t hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = first; i < last; ++i) {
      const RecordedRay& r = rays[i];
      RTCRayHit ray =
          ray_from({r.origin[0], r.origin[1], r.origin[2]}, {r.direction[0], r.direction[1], r.direction[2]});
      if (r.shadow) {
        ray.ray.tfar = shadow_end;
        bare_occluded(scene, &context, &ray.ray);
        hits += ray.ray.tfar < 0.0f;
      } else {
        bare_intersect(scene, &context, &ray);
        hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      }
    }
    return hits;
  });
}

std::size_t trace_through_camera(const Scene& scene, const EyeCamera& camera, int samples) {
  const auto width = static_cast<std::size_t>(camera.width());
  return in_parallel(width * static_cast<std::size_t>(camera.height()), 64, [&](std::size_t first, std::size_t last) {
    std::size_t found = 0;
    CameraHits hits;
    for (std::size_t pixel = first; pixel < last; ++pixel) {
      const PixelSequence sequence(Sequence::Sobol, 1, static_cast<std::uint32_t>(pixel));
      for (int sample = 0; sample < samples; sample += CameraRayBlock::size) {
        const int count = std::min(CameraRayBlock::size, samples - sample);
        trace_camera_rays(scene, camera, static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                          static_cast<std::uint32_t>(sample), count, sequence, hits);
        for (int i = 0; i < count; ++i) found += hits.hit(i);
      }
    }
    return found;
  });
}

/// The rays of `work`, in the order in which one thread sends them.
std::vector<RecordedRay> recorded(const std::function<void()>& work) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<RecordedRay> rays;
  const RayRecorder recorder(rays);
  work();
  return rays;
}

/// Throws unless both sides saw the same: a benchmark that traces other rays would say nothing.
void require_equal(std::size_t ours, std::size_t bare, const std::string& what) {
  // Packets and single rays may differ by rounding at the edges of triangles.
  if (std::max(ours, bare) - std::min(ours, bare) > bare / 10000)
    throw std::runtime_error(what + ": " + std::to_string(ours) + " hits against " + std::to_string(bare));
}

Result bench_camera(const Options& options, const Scene& scene, const std::string& name, double radius) {
  const EyeCamera camera(testing::scene_plain_pose(), testing::focused_lens(radius, 1.05));
  const auto ours = [&] { return trace_through_camera(scene, camera, options.samples); };
  const std::vector<RecordedRay> rays = recorded(ours);
  const auto bare = [&] { return trace_bare(scene.embree(), rays); };
  require_equal(ours(), bare(), name);
  return compare(options, name, "Mray/s", 1e-6 * static_cast<double>(rays.size()), options.require_camera, ours, bare);
}

Result bench_path(const Options& options, const Scene& scene, const std::string& name) {
  const EyeCamera camera(testing::scene_plain_pose(), testing::focused_lens(0.02, 1.05));
  RenderSettings settings;
  settings.samples_per_pixel = options.samples;
  const auto ours = [&] { render(scene, camera, settings); };
  const std::vector<RecordedRay> rays = recorded(ours);
  const auto bare = [&] { trace_bare(scene.embree(), rays); };
  const double samples = static_cast<double>(camera.width()) * camera.height() * options.samples;
  return compare(
      options, name + " (" + std::to_string(static_cast<double>(rays.size()) / samples).substr(0, 4) + " rays/sample)",
      "Msample/s", 1e-6 * samples, options.require_path, ours, bare);
}

void print_table(const std::vector<Result>& results, const Options& options, std::FILE* out) {
  std::fprintf(out, "%d threads, %d interleaved repetitions, medians\n", options.threads, options.repetitions);
  std::fprintf(out, "%-40s %10s %10s %-10s %7s %9s\n", "", "ours", "bare", "", "ratio", "required");
  for (const Result& r : results)
    std::fprintf(out, "%-40s %10.2f %10.2f %-10s %7.3f %9.2f%s\n", r.name.c_str(), r.ours, r.bare, r.unit.c_str(),
                 r.ratio, r.required, r.passed() ? "" : "  MISSED");
}

void print_json(const std::vector<Result>& results, const Options& options) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Result& r : results)
    rows.push_back({{"name", r.name},
                    {"unit", r.unit},
                    {"ours", r.ours},
                    {"bare", r.bare},
                    {"ratio", r.ratio},
                    {"required", r.required},
                    {"passed", r.passed()}});
  const nlohmann::ordered_json report = {{"threads", options.threads},
                                         {"repetitions", options.repetitions},
                                         {"samples_per_pixel", options.samples},
                                         {"results", rows}};
  std::printf("%s\n", report.dump(2).c_str());
}

int run(const Options& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  const Scene scene(testing::scene_plain());
  const std::vector<Result> results{bench_camera(options, scene, "camera, lens of 20 mm radius", 0.02),
                                    bench_camera(options, scene, "camera, eye of 2 mm radius", 0.002),
                                    bench_path(options, scene, "path, lens of 20 mm radius")};
  print_table(results, options, options.json ? stderr : stdout);
  if (options.json) print_json(results, options);
  return std::all_of(results.begin(), results.end(), [](const Result& r) { return r.passed(); }) ? 0 : 1;
}

}  // namespace
}  // namespace sturm::bench

int main(int argc, char** argv) {
  sturm::bench::Options options;
  CLI::App app("Camera rays and path tracing against bare Embree");
  app.add_option("--threads", options.threads, "worker threads")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", options.repetitions, "interleaved pairs of timings")->check(CLI::Range(5, 1000));
  app.add_option("--samples", options.samples, "samples per pixel")->check(CLI::PositiveNumber);
  app.add_option("--require-camera", options.require_camera, "least ratio of camera rays");
  app.add_option("--require-path", options.require_path, "least ratio of path tracing");
  app.add_flag("--json", options.json, "JSON on stdout, the table on stderr");
  CLI11_PARSE(app, argc, argv);
  try {
    return sturm::bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_rays: %s\n", error.what());
    return 3;
  }
}
