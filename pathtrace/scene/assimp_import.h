#pragma once
#include "io/specs/scene_spec.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Reads a model file: glTF with gltf/gltf_import.h, OBJ with obj/obj_import.h, PLY with ply/ply_import.h, others
/// (COLLADA, STL, …) with Assimp. Every mesh of every node, in world coordinates, as triangles.
///
/// - `scale` > 0: metres per unit of the file. Vertices are neither merged nor reordered; polygons become triangles
/// with the same
///   winding, and a mirroring node transform turns the winding over so that surfaces keep facing the way they did.
/// - Base colour (OBJ Kd) → albedo, in [0, 1]; emissive colour (OBJ Ke) → radiance as it is;
///   base colour texture (OBJ map_Kd) → albedo texture, multiplied, its v coordinate running upwards from the image's
///   last row. Texture values are taken as linear or decoded from sRGB as `texture_encoding` says; a grey texture
///   becomes RGB, alpha is left out. Textures of materials that no mesh uses are not loaded. All materials are Lambert
///   but those of glTF.
/// - Vertex normals are kept where they differ from the triangles' own by more than 0.1 %.
/// - A mesh that several nodes show becomes a prototype with instances, unless it emits.
/// - A file without materials (STL) is grey with a reflectance of 0.6, or has the colours of its vertices alone.
/// - Left out, with a note in the description: other properties (specular, metallic, bump, transparency), lights,
/// cameras, animation.
///
/// Throws InputError, naming the file: unreadable or empty models, missing material libraries, materials and textures,
/// embedded textures, positions that are not finite, colours out of range.
/// Overrides are not applied here.
SceneDescription import_model(const ModelSpec& spec);

}  // namespace sturm
