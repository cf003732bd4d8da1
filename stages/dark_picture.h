#pragma once
#include <optional>
#include <string>

#include "io/images/image.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// Why a picture of the scene is black in every pixel, in words for its user; none where any light was seen.
std::optional<std::string> reason_of_darkness(const Scene& scene, const Image& radiance);

}  // namespace sturm
