#pragma once
#include "pathtrace/scene/scene_description.h"
#include "stages/page/scene_arrays.h"

namespace sturm {

/// Puts the triangles of all meshes and instances of a scene, in the world, into the arrays of a viewer's scene; adds
/// `positions`, `normals`, `texture_coordinates`, `emission_coordinates`, `colours`, `triangles` and `meshes` to its
/// header.
void add_geometry(const SceneDescription& scene, SceneArrays& arrays, Json& header);

}  // namespace sturm
