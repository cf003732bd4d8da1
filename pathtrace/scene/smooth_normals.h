#pragma once
#include <Eigen/Core>
#include <vector>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// True where some normal, one for each position of the mesh, is off its triangle's own by more than 0.1 %.
bool normals_bend(const Mesh& mesh, const std::vector<Eigen::Vector3f>& normals);

}  // namespace sturm
