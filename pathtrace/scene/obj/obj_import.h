#pragma once
#include "io/specs/scene_spec.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Reads an OBJ file with its material libraries, in place (pathtrace/scene/model_placement.h); positions are double
/// until they stand there.
///
/// - The faces of one object, group and material are one mesh, named after the group, else the object, else
///   "defaultobject". Overrides find it by the object and by each of its groups, too.
/// - Vertices with the same position, texture coordinate and normal are shared. Normals are kept where they bend the
///   surface (pathtrace/scene/vertex_normals.h).
/// - `mtllib` names one library, blanks and all, or several. They are looked for beside the OBJ file. Where several
///   define a material of the same name, the first counts.
/// - Faces without a material are Lambert's with a reflectance of 0.6, or of 1 under vertex colours. So are those of a
///   material that is not defined in a file that names no library, which is noted.
/// - Vertex colours are decoded as textures are (`texture_encoding`), which is noted.
///
/// Throws InputError that names the file, and the line where there is one: files that cannot be read, missing
/// libraries and textures, materials that no library defines, wrong numbers, no triangles.
SceneDescription import_obj(const ModelSpec& spec);

}  // namespace sturm
