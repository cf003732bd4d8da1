// What each item of the plan of work saves on a view that does not need the work, and what planning costs on one that
// needs it.
//
// Whole calls of render_view (reading of models, planning, building, rendering) with the item's switch off and on, in
// turn, off on off on; the ratio is the median over the pairs, with the standard error of a median of normal values of
// the same quartiles. Times are processor times of all threads, which other programs on the machine disturb little.
// `noise` is the mean variance of single samples without the item over that with it: items that change the noise save
// samples as well.
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "stages/render_stage.h"
#include "support/source_folder.h"

namespace sturm::bench {
namespace {

using Document = nlohmann::json;

struct Options {
  int threads = 1;
  int repetitions = 9;
  int size = 128, samples = 16;
  std::string only;
};

const std::string scenes = std::string(STURM_SOURCE_DIR) + "/configs/scenes/";

Document room(const Options& o) {
  return {{"format", "sturm.render/1"},
          {"scene", scenes + "cornell_box.json"},
          {"camera",
           {{"position_m", {0.278, 0.273, -0.8}},
            {"look_at_m", {0.278, 0.273, 0.0}},
            {"vfov_deg", 39.3077},
            {"resolution", {o.size, o.size}}}},
          {"eye",
           {{"prescription", {{"sphere_D", -1.5}, {"cylinder_D", -4}, {"axis_deg", 55}}},
            {"pupil_diameter_mm", 6},
            {"accommodation", {{"mode", "relaxed"}}}}},
          {"method", {{"type", "path_trace"}, {"ray_model", "power_matrix"}, {"samples_per_pixel", o.samples}}}};
}

Document set(Document document, const std::string& pointer, const Document& value) {
  document[Document::json_pointer(pointer)] = value;
  return document;
}

Document spherical(const Document& view) {
  return set(set(view, "/eye/prescription", {{"sphere_D", -1.5}}), "/eye/pupil_diameter_mm", 6);
}

Document quad(const std::string& material, const Document& corners) {
  return {{"material", material}, {"positions_m", corners}, {"faces", {{0, 1, 2, 3}}}};
}

/// Ground, walls 30 to 60 m away and a sky of one colour.
Document street(const Options& o) {
  Document view = room(o);
  view["scene"] = {{"materials", {{"ground", {{"albedo", {0.3, 0.3, 0.3}}}}, {"wall", {{"albedo", {0.6, 0.5, 0.4}}}}}},
                   {"meshes",
                    {quad("wall", {{-20, -1.6, -30}, {-2, -1.6, -60}, {-2, 12, -60}, {-20, 12, -30}}),
                     quad("wall", {{2, -1.6, -60}, {20, -1.6, -30}, {20, 12, -30}, {2, 12, -60}}),
                     quad("ground", {{-200, -1.6, 0}, {200, -1.6, 0}, {200, -1.6, -400}, {-200, -1.6, -400}})}},
                   {"environment", {{"radiance", {0.4, 0.6, 1.0}}}}};
  view["camera"] = {
      {"position_m", {0, 0, 0}}, {"look_at_m", {0, 0.08, -1}}, {"vfov_deg", 20}, {"resolution", {o.size, o.size}}};
  view["eye"] = {
      {"prescription", {{"sphere_D", 0}}}, {"pupil_diameter_mm", 3}, {"accommodation", {{"mode", "relaxed"}}}};
  return view;
}

/// A room, and a sign of forty panels on its roof, much brighter together than the lamp within.
Document room_with_a_sign(const Options& o) {
  Document view = room(o);
  Document meshes = {quad("white", {{0, 0, 0}, {0, 0, 0.56}, {0.56, 0, 0.56}, {0.56, 0, 0}}),
                     quad("white", {{0, 0, 0.56}, {0, 0.55, 0.56}, {0.56, 0.55, 0.56}, {0.56, 0, 0.56}}),
                     quad("white", {{0, 0, 0}, {0, 0.55, 0}, {0, 0.55, 0.56}, {0, 0, 0.56}}),
                     quad("white", {{0.56, 0, 0}, {0.56, 0, 0.56}, {0.56, 0.55, 0.56}, {0.56, 0.55, 0}}),
                     quad("lamp", {{0.2, 0.549, 0.2}, {0.35, 0.549, 0.2}, {0.35, 0.549, 0.35}, {0.2, 0.549, 0.35}})};
  for (int i = 0; i < 40; ++i) {
    const double x = 0.06 * (i % 8), z = 0.06 * (i / 8);
    meshes.push_back(
        quad("sign", {{x, 0.56, z}, {x, 0.56, z + 0.05}, {x + 0.05, 0.56, z + 0.05}, {x + 0.05, 0.56, z}}));
  }
  view["scene"] = {{"materials",
                    {{"white", {{"albedo", {0.7, 0.7, 0.7}}}},
                     {"lamp", {{"albedo", {0, 0, 0}}, {"emission", {10, 10, 10}}}},
                     {"sign", {{"albedo", {0, 0, 0}}, {"emission", {50, 50, 50}}}}}},
                   {"meshes", meshes}};
  return view;
}

Document predicted(Document view) {
  view["method"].erase("ray_model");
  view["method"]["type"] = "predict";
  return view;
}

/// A screen in focus behind beads that are not; both ways to the same error.
Document adaptive_screen() {
  Document view = Document::parse(std::ifstream(std::string(STURM_SOURCE_DIR) + "/configs/views/near_screen.json"));
  view["camera"]["resolution"] = {240, 160};  // tiles are 16 px wide: a small picture has too few to end one by one
  view["method"]["stop"] = {{"relative_error", 0.02}};
  return view;
}

const Document lens = {{"vertex_distance_mm", 12},
                       {"center_thickness_mm", 3},
                       {"refractive_index", 1.5},
                       {"front", {{"type", "sphere"}, {"radius_mm", 100}}},
                       {"back", {{"type", "sphere"}, {"radius_mm", 80}}}};

/// One row: a view with an item's switch off and on.
struct Row {
  std::string item, view;
  Document document;
  bool profits;
};

std::vector<Row> rows(const Options& o) {
  const Document box = room(o), far = street(o);
  const Document glossy = set(far, "/scene/materials/ground", {{"type", "plastic"}, {"albedo", {0.3, 0.3, 0.3}}});
  const Document wearing = set(box, "/spectacles", lens);
  const auto pair = [](const Document& view, double distance_mm) {
    return set(view, "/camera/stereo", {{"interpupillary_distance_mm", distance_mm}});
  };
  return {{"scalar_power", "room, sphere, power_matrix", spherical(box), true},
          {"scalar_power", "room, sphere, sin2_radial", set(spherical(box), "/method/ray_model", "sin2_radial"), true},
          {"scalar_power", "room, sphere, zernike", set(spherical(box), "/method/ray_model", "zernike"), true},
          {"scalar_power", "room, cylinder", box, false},
          {"zero_pupil", "room, pupil 0", set(box, "/eye/pupil_diameter_mm", 0), true},
          {"zero_pupil", "room, pupil 0, halton",
           set(set(box, "/eye/pupil_diameter_mm", 0), "/method/sampler", "halton"), true},
          {"zero_pupil", "room, pupil 6 mm", box, false},
          {"sharp_pixels", "street, emmetrope", far, true},
          {"sharp_pixels", "room, cylinder", box, false},
          {"refraction", "room, naked eye", box, true},
          {"refraction", "room, spectacles", wearing, false},
          {"surface_models", "street", far, true},
          {"surface_models", "street, glossy ground", glossy, false},
          {"shading_frames", "room", box, true},
          {"shading_frames", "street (has a sky)", far, false},
          {"environment_light", "street", far, true},
          {"environment_light", "room", box, false},
          {"unseen_emitters", "room with a sign outside", room_with_a_sign(o), true},
          {"unseen_emitters", "room", box, false},
          {"converged_tiles", "screen behind beads, adaptive", adaptive_screen(), true},
          {"converged_tiles", "room", box, false},
          {"same_views", "room, eyes in one place", pair(box, 0.0), true},
          {"same_views", "room, eyes 63 mm apart", pair(box, 63.0), false},
          {"sharp_spots", "street, predicted", predicted(far), true},
          {"sharp_spots", "room, predicted", predicted(box), false}};
}

struct Timed {
  double seconds, plan_seconds, variance;
};

double mean_of(const Image& image) {
  double sum = 0.0;
  for (const float value : image.pixels) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.pixels.size());
}

Timed timed(const RenderSpec& spec) {
  const std::clock_t start = std::clock();
  const RenderOutput output = render_view(spec, {});
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto variance = output.image.layers.find("variance");
  return {seconds, output.seconds.at("plan"), variance == output.image.layers.end() ? 0.0 : mean_of(variance->second)};
}

void measure(const Row& row, const Options& options) {
  const RenderSpec on = read_render_spec(row.document, "-");
  const RenderSpec off = read_render_spec(set(row.document, "/method/skip", {{row.item, false}}), "-");
  const double off_variance = timed(off).variance, on_variance = timed(on).variance;  // warms up, too
  std::vector<double> off_times, on_times, ratios, plans;
  for (int i = 0; i < options.repetitions; ++i) {
    off_times.push_back(timed(off).seconds);
    const Timed t = timed(on);
    on_times.push_back(t.seconds);
    plans.push_back(t.plan_seconds / t.seconds);
    ratios.push_back(off_times.back() / on_times.back());
  }
  std::sort(ratios.begin(), ratios.end());
  const std::size_t n = ratios.size();
  const std::string noise =
      off_variance > 0.0 && on_variance > 0.0 ? std::to_string(off_variance / on_variance).substr(0, 5) : "";
  // Quartiles of normal values lie 1.349 σ apart; their median has the standard error √(π/2) σ/√n.
  const double error = 1.2533 * (ratios[n - 1 - n / 4] - ratios[n / 4]) / 1.349 / std::sqrt(static_cast<double>(n));
  std::printf("| %s | %s | %s | %.4f | %.4f | %.4f ± %.4f | %s | %.2f %% |\n", row.item.c_str(), row.view.c_str(),
              row.profits ? "yes" : "no", median(off_times), median(on_times), median(ratios), error, noise.c_str(),
              100.0 * median(plans));
  std::fflush(stdout);
}

int run(const Options& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  std::printf(
      "%d thread(s), %d interleaved repetitions, medians of processor time, %d x %d px, %d samples per pixel\n\n",
      options.threads, options.repetitions, options.size, options.size, options.samples);
  std::printf(
      "| item | view | profits | off s | on s | off/on | noise | planning |\n|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows(options))
    if (options.only.empty() || row.item == options.only) measure(row, options);
  return 0;
}

}  // namespace
}  // namespace sturm::bench

int main(int argc, char** argv) {
  sturm::bench::Options options;
  CLI::App app("What the items of the plan of work save");
  app.add_option("--threads", options.threads, "worker threads")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", options.repetitions, "interleaved pairs of timings")->check(CLI::Range(3, 1000));
  app.add_option("--size", options.size, "pixels along each side")->check(CLI::Range(8, 4096));
  app.add_option("--samples", options.samples, "samples per pixel")->check(CLI::PositiveNumber);
  app.add_option("--only", options.only, "rows of this item only");
  CLI11_PARSE(app, argc, argv);
  try {
    return sturm::bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_work_plan: %s\n", error.what());
    return 3;
  }
}
