#include "io/specs/skip_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

SkipSpec read_skips(const Json& resolved) {
  const auto read = [&](const char* key) { return resolved.at(key).get<bool>(); };
  SkipSpec skip;
  skip.scalar_power = read("scalar_power");
  skip.zero_pupil = read("zero_pupil");
  skip.sharp_pixels = read("sharp_pixels");
  skip.refraction = read("refraction");
  skip.surface_models = read("surface_models");
  skip.shading_frames = read("shading_frames");
  skip.environment_light = read("environment_light");
  skip.unseen_emitters = read("unseen_emitters");
  skip.converged_tiles = read("converged_tiles");
  skip.same_views = read("same_views");
  skip.sharp_spots = read("sharp_spots");
  return skip;
}

}  // namespace sturm
