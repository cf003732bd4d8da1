#pragma once
#include <filesystem>

namespace sturm {

/// Checks what a glTF 2.0 file (.gltf, .glb) claims before Assimp believes it: nodes must form trees; buffers, views
/// and accessors must fit into the bytes that are there, so that no header makes the program ask for more memory than
/// the file is long; files must exist; no required extension may be unknown. Throws InputError that names file and JSON
/// pointer.
void check_gltf(const std::filesystem::path& file);

}  // namespace sturm
