#include "stages/path_traced_layers.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "pathtrace/film/denoiser.h"

namespace sturm {

namespace {

double mean_samples(const PassSummary& passes, const RenderSpec& spec) {
  return static_cast<double>(passes.samples_kept) / (static_cast<double>(spec.camera.width) * spec.camera.height);
}

}  // namespace

const char* const denoised_note =
    "the layer \"denoised\" and the PNG are filtered for looking at; the main layer is raw, and no measure of "
    "agreement reads the filtered "
    "one";

bool may_stop_early(const RenderSpec& spec) {
  return spec.stop.seconds || spec.stop.relative_error;
}

Json sampling_json(const PassSummary& passes, const RenderSpec& spec) {
  const char* ended_by = "samples";
  if (passes.interrupted)
    ended_by = "seconds";
  else if (spec.stop.relative_error && passes.tiles_converged == passes.tiles)
    ended_by = "relative_error";
  Json section{{"passes", passes.passes},
               {"samples_spent", passes.samples_spent},
               {"samples_kept", passes.samples_kept},
               {"samples_saved", passes.samples_saved},
               {"kept_samples_per_pixel", mean_samples(passes, spec)},
               {"ended_by", ended_by}};
  if (spec.stop.relative_error) {
    section["tiles"] = passes.tiles;
    section["tiles_converged"] = passes.tiles_converged;
    section["measured_relative_error"] = *passes.measured_relative_error;
  }
  return section;
}

std::string interruption_note(const PassSummary& passes, const RenderSpec& spec) {
  std::string note =
      "ended by stop.seconds: how many samples that allows depends on the machine and its load, so the picture is not "
      "repeated bit for bit";
  if (!spec.stop.relative_error)
    note += "; samples_per_pixel " + std::to_string(std::llround(mean_samples(passes, spec))) +
            " without stop.seconds repeats it";
  return note;
}

std::map<std::string, Image> path_traced_layers(RenderResult result, const RenderSpec& spec) {
  std::map<std::string, Image> layers;
  if (spec.denoise) layers["denoised"] = denoised(result, mean_samples(result.passes, spec), *spec.denoise);
  if (spec.stop.relative_error) {
    layers["samples"] = std::move(result.samples);
    layers["mean_variance"] = std::move(result.mean_variance);
  }
  layers[""] = std::move(result.radiance);
  layers["variance"] = std::move(result.variance);
  layers["albedo"] = std::move(result.albedo);
  layers["normal"] = std::move(result.normal);
  layers["depth"] = std::move(result.depth);
  return layers;
}

}  // namespace sturm
