#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace sturm {

/// The positions of the corners of an STL file's facets, in their order and as precisely as a text states them; Assimp
/// rounds them. Empty where the file is none or is binary, with single precision.
std::vector<Eigen::Vector3d> stated_positions(const std::filesystem::path& file);

}  // namespace sturm
