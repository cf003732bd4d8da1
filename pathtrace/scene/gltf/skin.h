#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "pathtrace/scene/gltf/accessor.h"

namespace sturm::gltf {

/// The joints that move a vertex: their numbers in the skin, and weights. Where a file has more sets of four, the first
/// two are taken.
struct VertexPose {
  std::array<std::uint32_t, 8> joints{};
  std::array<float, 8> weights{};
};

/// Where each joint of a skin takes its vertices, as the nodes stand: world from node × inverse bind matrix. Throws
/// InputError.
std::vector<Eigen::Affine3d> joint_transforms(const Document& document, std::size_t skin,
                                              const std::vector<Eigen::Affine3d>& world_from_node);

/// The transform of one vertex: the weighted mean of its joints', with the weights' sum made 1. Joints that the skin
/// does not have count nothing; without any the transform is the identity.
Eigen::Affine3d posed(const VertexPose& pose, const std::vector<Eigen::Affine3d>& joints);

}  // namespace sturm::gltf
