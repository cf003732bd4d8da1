#pragma once
#include <string>

#include "pathtrace/scene/scene.h"

namespace sturm {

/// A scene as a viewer's page reads it: sturm.viewer_scene/1 (docs/formats/viewer_scene.md). `built` is the scene of
/// this description: what it accepts can be written.
std::string viewer_scene(const SceneDescription& description, const Scene& built);

}  // namespace sturm
