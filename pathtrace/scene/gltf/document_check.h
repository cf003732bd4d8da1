#pragma once
#include <span>
#include <vector>

#include "io/json/json.h"

namespace sturm::gltf {

/// What a glTF 2.0 document claims before its buffers are known: its version, the extensions that it requires
/// (extensions.h), and nodes that form trees. Throws InputError that names file and JSON pointer.
void check_head(const Json& gltf, const Source& root);

/// Views and accessors must fit into the bytes that are there, so that no header makes the program ask for more memory
/// than the file is long; embedded images must name a view.
void check_contents(const Json& gltf, const Source& root, const std::vector<std::span<const unsigned char>>& buffers);

}  // namespace sturm::gltf
