#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace sturm {

/// The positions of a PLY file's vertices (text, or binary with doubles), or of the corners of an STL file's facets
/// (text), in their order and as precisely as the file states them; Assimp rounds them. Empty where the file states
/// them in single precision or is none of these.
std::vector<Eigen::Vector3d> stated_positions(const std::filesystem::path& file);

}  // namespace sturm
