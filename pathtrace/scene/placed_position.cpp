#include "pathtrace/scene/placed_position.h"

#include "io/files/error.h"
#include "pathtrace/scene/message_text.h"

namespace sturm {

Eigen::Vector3f placed_position(const ModelPlacement& placement, const Eigen::Vector3d& in_file,
                                const std::filesystem::path& file, const std::string& mesh) {
  constexpr double largest_coordinate = 1e6;  // [m], of a scene
  const Eigen::Vector3d world = placement.point(in_file);
  if (!(world.array().abs() <= largest_coordinate).all())
    throw InputError(
        file.string(), "mesh " + in_quotes(mesh),
        "(" + exact_number(world.x()) + ", " + exact_number(world.y()) + ", " + exact_number(world.z()) + ")",
        "coordinates within ±1e6 m; \"position_m\" of the model can bring it there");
  return world.cast<float>();
}

}  // namespace sturm
