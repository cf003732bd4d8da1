#pragma once
#include "io/specs/scene_spec.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Reads a PLY file (ply_model.h) as one mesh that has the file's name without its suffix: in the scene's coordinates,
/// Lambert, of the colours of its vertices or of the texture that a comment names (both: their product), else grey with
/// a reflectance of 0.6. Throws InputError.
SceneDescription import_ply(const ModelSpec& spec);

}  // namespace sturm
