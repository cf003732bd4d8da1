#pragma once
#include "io/specs/scene_spec.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Everything that a scene names in one description: what is given in place first, then the models in their order,
/// loaded from their files (pathtrace/scene/assimp_import.h). Throws InputError.
SceneDescription build_scene(const SceneSpec& spec);

}  // namespace sturm
