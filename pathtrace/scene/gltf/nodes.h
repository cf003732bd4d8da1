#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "pathtrace/scene/gltf/document.h"

namespace sturm::gltf {

/// The nodes of the scene that a file shows, and where they stand.
struct Nodes {
  std::vector<std::size_t> shown;                ///< in the order of a walk through the trees, parents first
  std::vector<Eigen::Affine3d> world_from_node;  ///< of every node of the file
};

/// The scene that the file names, else its first; a file without scenes shows all its nodes. Subtrees that
/// KHR_node_visibility hides are left out. `notes` gets what else is left out. Throws InputError.
Nodes nodes_of(const Document& document, std::vector<std::string>& notes);

/// Where a node is shown: once, or at each place of EXT_mesh_gpu_instancing.
std::vector<Eigen::Affine3d> places_of(const Document& document, std::size_t node,
                                       const Eigen::Affine3d& world_from_node);

}  // namespace sturm::gltf
