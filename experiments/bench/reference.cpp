#include "experiments/bench/reference.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/run/progress.h"
#include "experiments/run/replicates.h"
#include "experiments/run/scene_fingerprint.h"
#include "io/files/atomic_file.h"
#include "io/files/build_info.h"
#include "io/files/error.h"
#include "io/files/sha256.h"
#include "io/images/exr.h"
#include "io/json/json_text.h"
#include "io/json/manifest.h"
#include "pathtrace/scene/scene_import.h"
#include "stages/image_files.h"
#include "stages/render_stage.h"

namespace sturm {

namespace {

constexpr int reference_index = 0;  // of the seeds that a benchmark's seed gives; settings have the numbers from 1 on
constexpr const char* half_names[] = {"first_half", "second_half"};

/// Renders both halves and stores them. The JSON file appears last: without it the pictures do not count.
void make_reference(const BenchView& view, std::uint64_t seed, const std::filesystem::path& stem,
                    const std::string& key, bool quiet) {
  RenderSpec spec = view.reference;
  const double samples =
      static_cast<double>(spec.camera.width) * spec.camera.height * static_cast<double>(spec.samples_per_pixel);
  spec.samples_per_pixel /= 2;
  Progress progress("reference of " + view.id, samples, "samples", quiet);
  LayeredImage halves;
  const std::string started = utc_now();
  for (int half = 0; half < 2; ++half) {
    spec.seed = replicate_seed(replicate_seed(seed, reference_index), half);
    RenderOutput output = render_view(spec, [&](double fraction) { progress.update(0.5 * (half + fraction)); });
    halves.layers[half_names[half]] = std::move(output.image.layers.at(""));
  }
  progress.update(1.0);
  const ReferenceImage image(halves.layers.at(half_names[0]), halves.layers.at(half_names[1]), std::nullopt,
                             view.exposure);
  halves.layers[""] = image.mean();
  write_exr(stem.string() + ".exr", halves);
  write_png(stem.string() + ".png", image.mean(), view.exposure);
  const BenchReferenceOrigin origin{.key = key,
                                    .samples_per_pixel = static_cast<std::int64_t>(view.reference.samples_per_pixel),
                                    .seconds = progress.seconds(),
                                    .started_utc = started,
                                    .version = std::string(build_info().version),
                                    .commit = std::string(build_info().commit)};
  write_file_atomically(stem.string() + ".json", json_text(to_json(origin), 1) + "\n");
}

ByError<Number> by_error(const PictureErrors& floor) {
  ByError<Number> values;
  for (const ErrorKind& kind : error_kinds)
    values[std::string(kind.name)] = kind.is_root ? std::sqrt(floor.*kind.of) : floor.*kind.of;
  return values;
}

}  // namespace

std::string reference_key(const BenchView& view, std::uint64_t seed) {
  std::string facts =
      spec_hash(*view.reference.resolved) + std::to_string(seed) + scene_fingerprint(build_scene(view.reference.scene));
  for (const std::string& file : view.reference.input_files) facts += sha256_of_file(file);
  return sha256(facts);
}

BenchReference bench_reference(const BenchView& view, const std::string& key, std::uint64_t seed,
                               const std::filesystem::path& folder, bool quiet) {
  const std::string name = "references/" + view.id + "_" + key.substr(0, 16);
  const std::filesystem::path stem = folder / name;
  const auto file = [&](const char* suffix) { return stem.string() + suffix; };
  if (std::filesystem::exists(file(".json")) && std::filesystem::exists(file(".exr"))) {
    if (!quiet) std::fprintf(stderr, "reference of %s: %s.exr\n", view.id.c_str(), stem.c_str());
  } else {
    make_reference(view, seed, stem, key, quiet);
  }
  const LayeredImage halves = read_exr(file(".exr"));
  for (const char* half : half_names)
    if (!halves.layers.contains(half))
      throw InputError(file(".exr"), "", std::string("no layer ") + half, "a reference of this benchmark");
  ReferenceImage image(halves.layers.at(half_names[0]), halves.layers.at(half_names[1]),
                       view.max_neighbourhood_radiance, view.exposure);
  BenchReferenceFacts facts{reference_origin_from(load_json(file(".json")))};
  facts.file = name + ".exr";
  facts.picture = name + ".png";
  facts.noise_floor = by_error(image.noise_floor());
  facts.pixels_left_out = static_cast<std::int64_t>(image.pixels_left_out());
  return {std::move(image), std::move(facts)};
}

}  // namespace sturm
