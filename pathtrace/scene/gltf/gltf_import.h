#pragma once
#include "io/specs/scene_spec.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Reads a glTF 2.0 file (.gltf, .glb): every mesh of every node of its scene, in world coordinates, as triangles; what
/// pathtrace/scene/assimp_import.h says of scale, instances, normals and notes holds. Materials: gltf/materials.h;
/// meshes: gltf/primitive.h; nodes: gltf/nodes.h. Skinned meshes stand as their joints' nodes do, morph targets as
/// their default weights say. Extensions that are left out, animations, lights and cameras are noted; required
/// extensions that are not known are refused (gltf/extensions.h). Throws InputError that names file and JSON pointer.
SceneDescription import_gltf(const ModelSpec& spec);

}  // namespace sturm
