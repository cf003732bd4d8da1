#pragma once
#include <string>
#include <vector>

#include "io/specs/render_spec.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// What a viewer's page draws otherwise than the path tracer, or not at all: one sentence for each thing.
std::vector<std::string> undrawn(const SceneDescription& scene, const RenderSpec& spec);

}  // namespace sturm
