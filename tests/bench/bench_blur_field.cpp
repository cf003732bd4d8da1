// How fast a blur field is filled and read: 32 × 32 directions and 256 distances unless told otherwise, one thread.
//
//   field:    chief rays and all voxels by ray transfer, for a toric and for a free-form lens.
//   previous: the same voxels by the method before conoid tracing: every step for every voxel as published, and with
//   all that one direction
//             has in common taken out of the loop (tests/bench/hoisted_previous.h). The chief rays are traced once per
//             direction in both.
//   analytic: the field without samples in depth, its building and its look-ups.
//   growth:   chief rays and voxels for n × n × n grids, and the voxels against a plain fill of the same memory.
//
// All are timed in turn and compared in one run; the figures are medians. Exit status 1 if a required figure is missed.
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>

#include "bench/hoisted_previous.h"
#include "bench/timing.h"
#include "conoid/blur_field/depth_analytic_field.h"
#include "conoid/blur_field/voxel_fill.h"
#include "lensmodel/progressive.h"
#include "lensmodel/single_vision.h"

namespace sturm::bench {
namespace {

struct Options {
  int repetitions = 9;
  bool require = false;  ///< the bars decide the exit status
  bool json = false;
};

/// A figure, and what it has to reach: at most or at least.
struct Figure {
  std::string name, unit;
  double value;
  double at_most = HUGE_VAL, at_least = -HUGE_VAL;

  bool passed() const { return value <= at_most && value >= at_least; }
};

/// The −4.00 −2.00 × 30 of an eye that looks through it with a 100° field; relaxed.
struct Setup {
  std::string name;
  Spectacles lens{};
  Eye eye = Eye::with({-4.0, -2.0, 30.0, 12e-3}, 4e-3);
  FieldGrid grid{.tan_half_width = 0.7, .tan_half_height = 0.7};
};

/// Keeps a result alive that nobody reads.
volatile float sink;

void fill_previous(const Setup& setup, std::vector<float>& voxels) {
  const Eigen::Matrix2d needed = setup.eye.slope_matrix(0.0).matrix();
  float* out = voxels.data();
  for (int j = 0; j < setup.grid.ny; ++j)
    for (int i = 0; i < setup.grid.nx; ++i) {
      const PreviousMethod method(&setup.lens, setup.grid.line_of_sight(setup.grid.ndc_x(i), setup.grid.ndc_y(j)),
                                  setup.eye.rotation_center_m);
      for (int k = 0; k < setup.grid.nz; ++k, out += 4) {
        const auto x = method.blur(needed, setup.grid.vergence(k)).value().angular();
        for (int c = 0; c < 4; ++c) out[c] = static_cast<float>(x(c / 2, c % 2));
      }
    }
}

void fill_hoisted(const Setup& setup, std::vector<float>& voxels) {
  const Eigen::Matrix2d needed = setup.eye.slope_matrix(0.0).matrix();
  float* out = voxels.data();
  for (int j = 0; j < setup.grid.ny; ++j)
    for (int i = 0; i < setup.grid.nx; ++i) {
      const HoistedPrevious method(setup.lens, setup.grid.line_of_sight(setup.grid.ndc_x(i), setup.grid.ndc_y(j)),
                                   setup.eye.rotation_center_m);
      for (int k = 0; k < setup.grid.nz; ++k, out += 4) {
        const Eigen::Matrix2d x = method.angular_footprint(needed, setup.grid.vergence(k));
        for (int c = 0; c < 4; ++c) out[c] = static_cast<float>(x(c / 2, c % 2));
      }
    }
}

/// Throws unless the two ways of the previous method agree: a benchmark of something else would say nothing.
void require_equal(const std::vector<float>& a, const std::vector<float>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= 1e-5f * (1.0f + std::abs(a[i]))))
      throw std::runtime_error("the hoisted method differs from the published one");
}

void bench_lens(const Setup& setup, double most_ms, int repetitions, std::vector<Figure>& figures) {
  const Spectacles* lens = &setup.lens;
  const double center = setup.eye.rotation_center_m;
  std::vector<float> published(4 * setup.grid.voxels()), hoisted(published.size());
  fill_previous(setup, published);
  fill_hoisted(setup, hoisted);
  require_equal(published, hoisted);
  std::vector<double> field_s, previous_s, hoisted_s, analytic_s, ratio, hoisted_ratio, analytic_ratio;
  for (int r = 0; r < repetitions; ++r) {
    field_s.push_back(seconds([&] {
      const TracedDirections directions = trace_directions(lens, center, setup.grid);
      sink = *fill_voxels(lens, setup.eye, setup.grid, directions).column(0);
    }));
    previous_s.push_back(seconds([&] { fill_previous(setup, published); }));
    hoisted_s.push_back(seconds([&] { fill_hoisted(setup, hoisted); }));
    analytic_s.push_back(seconds([&] {
      const TracedDirections directions = trace_directions(lens, center, setup.grid);
      sink = DepthAnalyticField(setup.grid, directions, setup.eye.correction).nodes()[0].a[0];
    }));
    ratio.push_back(previous_s.back() / field_s.back());
    hoisted_ratio.push_back(hoisted_s.back() / field_s.back());
    analytic_ratio.push_back(previous_s.back() / analytic_s.back());
  }
  figures.push_back({setup.name + ": field, chief rays included", "ms", 1e3 * median(field_s), most_ms});
  figures.push_back({setup.name + ": previous method as published", "ms", 1e3 * median(previous_s)});
  figures.push_back({setup.name + ": previous method, hoisted", "ms", 1e3 * median(hoisted_s)});
  figures.push_back({setup.name + ": previous as published / field", "x", median(ratio), HUGE_VAL, 7.5});
  figures.push_back({setup.name + ": previous hoisted / field", "x", median(hoisted_ratio)});
  figures.push_back(
      {setup.name + ": previous as published / analytic field", "x", median(analytic_ratio), HUGE_VAL, 30.0});
}

void bench_look_up(const Setup& setup, int repetitions, std::vector<Figure>& figures) {
  const TracedDirections directions = trace_directions(&setup.lens, setup.eye.rotation_center_m, setup.grid);
  const DepthAnalyticField analytic(setup.grid, directions, setup.eye.correction);
  const VoxelField voxels = fill_voxels(&setup.lens, setup.eye, setup.grid, directions);
  constexpr std::size_t count = 1 << 20;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> ndc(-1.0f, 1.0f), vergence(0.0f, 4.0f);
  std::vector<std::array<float, 3>> places(count);
  for (auto& p : places) p = {ndc(random), ndc(random), vergence(random)};
  std::vector<double> analytic_s, voxel_s;
  for (int r = 0; r < repetitions; ++r) {
    analytic_s.push_back(seconds([&] {
      float sum = 0.0f;
      for (const auto& p : places) sum += (*analytic.angular_footprint(p[0], p[1], p[2], 0.5f))(0, 0);
      sink = sum;
    }));
    voxel_s.push_back(seconds([&] {
      float sum = 0.0f;
      for (const auto& p : places) sum += (*voxels.angular_footprint(p[0], p[1], p[2]))(0, 0);
      sink = sum;
    }));
  }
  figures.push_back({setup.name + ": look-up in the analytic field", "ns", 1e9 * median(analytic_s) / count, 30.0});
  figures.push_back({setup.name + ": look-up in the voxels", "ns", 1e9 * median(voxel_s) / count});
}

/// Least times of chief rays [ms] and of voxels [ms], which a busy machine disturbs least, and the median of the time
/// of a plain fill of the same memory over that of the voxels.
struct GridTimes {
  double rays, voxels, plain_ratio;
};

double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

GridTimes time_grid(const Setup& setup, int repetitions) {
  const auto trace = [&] { return trace_directions(&setup.lens, setup.eye.rotation_center_m, setup.grid); };
  const TracedDirections directions = trace();
  std::vector<double> rays, voxels, ratio;
  for (int r = 0; r < repetitions; ++r) {
    rays.push_back(seconds([&] { sink = static_cast<float>(trace().counters.usable); }));
    voxels.push_back(seconds([&] { sink = *fill_voxels(&setup.lens, setup.eye, setup.grid, directions).column(0); }));
    const double plain = seconds([&] {
      const auto memory = std::make_unique_for_overwrite<float[]>(4 * setup.grid.voxels());
      std::fill_n(memory.get(), 4 * setup.grid.voxels(), static_cast<float>(r));
      sink = memory[setup.grid.voxels()];
    });
    ratio.push_back(plain / voxels.back());
  }
  return {1e3 * least(rays), 1e3 * least(voxels), median(ratio)};
}

void bench_growth(Setup setup, int repetitions, std::vector<Figure>& figures) {
  // Grids below 1 MB stay in the caches of the processor, where a plain fill is faster than any arithmetic: no bar for
  // them.
  const auto add = [&](const std::string& label, double plain_bar) {
    const GridTimes times = time_grid(setup, repetitions);
    figures.push_back({label + ": chief rays", "ms", times.rays});
    figures.push_back({label + ": voxels", "ms", times.voxels});
    figures.push_back(
        {label + ": plain fill of the same memory / voxels", "x", times.plain_ratio, HUGE_VAL, plain_bar});
    return times;
  };
  add("32 x 32 x 256", 0.2);
  std::vector<GridTimes> times;
  for (const int n : {16, 32, 64, 128}) {
    setup.grid.nx = setup.grid.ny = setup.grid.nz = n;
    times.push_back(add("n = " + std::to_string(n), n >= 64 ? 0.2 : -HUGE_VAL));
  }
  // From 32 to 128: small grids pay for starting up.
  figures.push_back(
      {"growth of the chief rays, exponent of n", "", std::log2(times[3].rays / times[1].rays) / 2.0, 2.2, 1.8});
  figures.push_back({"growth of the voxels, exponent of n", "", std::log2(times[3].voxels / times[1].voxels) / 2.0});
}

void bench_memory(Setup setup, std::vector<Figure>& figures) {
  setup.grid.nx = setup.grid.ny = 64;
  const TracedDirections directions = trace_directions(&setup.lens, setup.eye.rotation_center_m, setup.grid);
  const VoxelField field = fill_voxels(&setup.lens, setup.eye, setup.grid, directions);
  figures.push_back({"64 x 64 x 256 voxels", "MB", 1e-6 * static_cast<double>(field.memory_bytes()), 20.0});
}

void print_table(const std::vector<Figure>& figures, const Options& options, std::FILE* out) {
  std::fprintf(out, "one thread, medians of %d repetitions in turn\n", options.repetitions);
  for (const Figure& f : figures) {
    char bar[32] = "";
    if (f.at_least > -HUGE_VAL) std::snprintf(bar, sizeof bar, ">= %g", f.at_least);
    if (f.at_most < HUGE_VAL) std::snprintf(bar, sizeof bar, "<= %g", f.at_most);
    std::fprintf(out, "%-58s %10.3f %-3s %10s%s\n", f.name.c_str(), f.value, f.unit.c_str(), bar,
                 f.passed() ? "" : "  MISSED");
  }
}

int run(const Options& options) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Setup toric{.name = "toric", .lens = single_vision({-4.0, -2.0, 30.0}, {})};
  ProgressiveDesign design;
  design.zone_width_m = 10e-3;
  const Setup free_form{.name = "free-form", .lens = progressive_lens({-4.0, -2.0, 30.0, 12e-3}, design).lens};
  std::vector<Figure> figures;
  bench_lens(toric, 5.0, options.repetitions, figures);
  bench_lens(free_form, 15.0, options.repetitions, figures);
  bench_look_up(toric, options.repetitions, figures);
  bench_memory(toric, figures);
  bench_growth(toric, options.repetitions, figures);
  print_table(figures, options, options.json ? stderr : stdout);
  if (options.json) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Figure& f : figures)
      rows.push_back({{"name", f.name}, {"unit", f.unit}, {"value", f.value}, {"passed", f.passed()}});
    std::printf("%s\n",
                nlohmann::ordered_json{{"repetitions", options.repetitions}, {"figures", rows}}.dump(2).c_str());
  }
  return !options.require || std::all_of(figures.begin(), figures.end(), [](const Figure& f) { return f.passed(); })
             ? 0
             : 1;
}

}  // namespace
}  // namespace sturm::bench

int main(int argc, char** argv) {
  sturm::bench::Options options;
  CLI::App app("Filling and reading blur fields");
  app.add_option("--repetitions", options.repetitions, "how often each is timed")->check(CLI::Range(3, 1000));
  app.add_flag("--require", options.require, "exit status 1 where a bar is missed");
  app.add_flag("--json", options.json, "JSON on stdout, the table on stderr");
  CLI11_PARSE(app, argc, argv);
  try {
    return sturm::bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_blur_field: %s\n", error.what());
    return 3;
  }
}
