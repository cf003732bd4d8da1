#include "pathtrace/scene/gltf/skin.h"

#include "pathtrace/scene/gltf/members.h"

namespace sturm::gltf {

std::vector<Eigen::Affine3d> joint_transforms(const Document& document, std::size_t skin,
                                              const std::vector<Eigen::Affine3d>& world_from_node) {
  const Json& source = document.json()["skins"][skin];
  const Source where = document.root() / "skins" / skin;
  if (!source.is_object()) where.fail(source, "an object");
  const Json& joints = list(source, "joints", where);
  Elements inverse_bind;
  const std::size_t accessors = list(document.json(), "accessors", document.root()).size();
  if (const auto matrices = index(source, "inverseBindMatrices", where, accessors, "accessor"))
    inverse_bind = elements(document, *matrices, 16, 16, where / "inverseBindMatrices");
  std::vector<Eigen::Affine3d> transforms;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].is_number_unsigned() || joints[i].get<std::size_t>() >= world_from_node.size())
      (where / "joints" / i).fail(joints[i], "the number of a node");
    Eigen::Affine3d transform = world_from_node[joints[i].get<std::size_t>()];
    if (i < inverse_bind.count())
      transform = transform * Eigen::Affine3d(Eigen::Matrix4f(inverse_bind.at(i)).cast<double>());
    transforms.push_back(transform);
  }
  return transforms;
}

Eigen::Affine3d posed(const VertexPose& pose, const std::vector<Eigen::Affine3d>& joints) {
  Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
  double weight = 0.0;
  for (std::size_t k = 0; k < pose.joints.size(); ++k) {
    if (!(pose.weights[k] > 0.0f) || pose.joints[k] >= joints.size()) continue;
    sum += static_cast<double>(pose.weights[k]) * joints[pose.joints[k]].matrix().topRows<3>();
    weight += static_cast<double>(pose.weights[k]);
  }
  Eigen::Affine3d mean = Eigen::Affine3d::Identity();
  if (weight > 0.0) mean.matrix().topRows<3>() = sum / weight;
  return mean;
}

}  // namespace sturm::gltf
