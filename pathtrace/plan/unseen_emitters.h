#pragma once
#include <vector>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Emitting triangles whose front side faces no surface: everything lies behind or in their plane, or beside it within
/// a millionth of its distance (the corners of one lamp's triangles are in one plane to rounding only). Instances count
/// by their boxes. Numbers as the scene's light set has them: triangles of the meshes in their order. After so many
/// looks at corners that planning would take longer than about 0.1 s, further emitters count as seen.
///
/// Leaving them out of the choice of a light takes nothing from the picture: what a path meets of them still counts, in
/// full.
std::vector<int> unseen_emitters(const SceneDescription& scene);

}  // namespace sturm
