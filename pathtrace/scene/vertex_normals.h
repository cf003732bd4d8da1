#pragma once
#include <Eigen/Core>
#include <vector>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// A file's normals (world, of any length, one for each position of the mesh or none) at unit length; none where they
/// say no more than the triangles, to 0.1 %, or where one is no direction at all.
std::vector<Eigen::Vector3f> normals_that_bend(const std::vector<Eigen::Vector3d>& normals, const Mesh& mesh);

}  // namespace sturm
