#pragma once
#include <filesystem>

namespace sturm {

/// Checks that every material library that an OBJ file names exists and every material that it uses is defined there.
/// Assimp only logs these and goes on with a grey of its own. Throws InputError that names the file and the line.
void check_obj_references(const std::filesystem::path& obj_file);

}  // namespace sturm
