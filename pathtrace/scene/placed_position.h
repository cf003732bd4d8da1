#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "pathtrace/scene/model_placement.h"

namespace sturm {

/// A position of a model file in the scene [m]. Throws InputError that names the file and the mesh where it is not
/// within ±1e6 m.
Eigen::Vector3f placed_position(const ModelPlacement& placement, const Eigen::Vector3d& in_file,
                                const std::filesystem::path& file, const std::string& mesh);

}  // namespace sturm
