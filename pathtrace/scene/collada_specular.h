#pragma once
#include <filesystem>
#include <set>
#include <string>

namespace sturm {

/// Materials of a COLLADA file, by their ids and by their names, whose effect states a specular part (Phong or Blinn,
/// not black). Assimp gives one to every material.
std::set<std::string> collada_materials_with_specular(const std::filesystem::path& file);

}  // namespace sturm
