#include "io/specs/stop_spec.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"

namespace sturm {

StopSpec read_stop(const Json& method, const Source& where, std::uint64_t samples_per_pixel) {
  StopSpec spec;
  const auto stop = method.find("stop");
  if (stop == method.end()) return spec;
  if (stop->contains("seconds")) spec.seconds = (*stop)["seconds"].get<double>();
  if (stop->contains("relative_error")) spec.relative_error = (*stop)["relative_error"].get<double>();
  // Four streams of at least two samples.
  if (spec.relative_error && samples_per_pixel < 8)
    (where / "samples_per_pixel").fail(samples_per_pixel, "at least 8 where \"stop\" has a \"relative_error\"");
  return spec;
}

std::optional<AdaptiveSpec> read_adaptive(const Json& method, const Source& where) {
  const auto adaptive = method.find("adaptive");
  if (adaptive == method.end()) return std::nullopt;
  if (!method.contains("stop") || !method["stop"].contains("relative_error"))
    (where / "adaptive").fail(*adaptive, "\"stop\": {\"relative_error\": …} beside it, the error to be reached");
  AdaptiveSpec spec;
  spec.tile_px = adaptive->value("tile_px", spec.tile_px);
  spec.min_samples_per_pixel = adaptive->value("min_samples_per_pixel", spec.min_samples_per_pixel);
  if (spec.min_samples_per_pixel % 4 != 0)
    (where / "adaptive" / "min_samples_per_pixel").fail(spec.min_samples_per_pixel, "a multiple of 4");
  return spec;
}

}  // namespace sturm
