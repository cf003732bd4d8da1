#pragma once
#include <string>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// SHA-256 over everything that a scene consists of once it is loaded: geometry, materials, textures, lights. Unlike
/// the hash of the scene's file it notices a change in any file that this one names.
std::string scene_fingerprint(const SceneDescription& scene);

}  // namespace sturm
