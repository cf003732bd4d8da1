#pragma once
#include <filesystem>

namespace sturm {

/// Checks that the nodes of a COLLADA file (.dae) do not contain themselves through `instance_node`, nest at most 1000
/// deep and unfold to at most a million nodes: Assimp follows them by recursion without looking. Throws InputError.
void check_collada(const std::filesystem::path& file);

}  // namespace sturm
