#include "stages/dark_picture.h"

#include <algorithm>

namespace sturm {

std::optional<std::string> reason_of_darkness(const Scene& scene, const Image& radiance) {
  if (std::any_of(radiance.pixels.begin(), radiance.pixels.end(), [](float value) { return value != 0.0f; }))
    return std::nullopt;
  if (scene.lights().size() == 0 && !scene.has_environment())
    return "the picture is black: the scene has no light, neither a lamp nor a surface that emits nor an environment";
  return "the picture is black: the camera sees no surface that light reaches";
}

}  // namespace sturm
