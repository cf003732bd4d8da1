#pragma once
#include <filesystem>

namespace sturm {

/// Throws InputError for a PLY file whose header Assimp would read for ever or believe too much: without an end, with
/// statements or types that the format does not have, or with more elements than the file has bytes.
void check_ply(const std::filesystem::path& file);

}  // namespace sturm
