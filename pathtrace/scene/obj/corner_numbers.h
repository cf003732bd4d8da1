#pragma once
#include <cstdint>
#include <vector>

#include "pathtrace/scene/obj/obj_model.h"

namespace sturm {

/// Numbers the different corners of one mesh after the other. Corners with the same position form a chain, which is
/// short.
class CornerNumbers {
 public:
  explicit CornerNumbers(std::size_t positions) : last_(positions, ObjModel::none) {}

  void begin_mesh() { first_link_ = static_cast<std::uint32_t>(links_.size()); }

  /// The number of a corner in the mesh that was begun last; a new one is put at the end of `corners`.
  std::uint32_t number(const ObjModel::Corner& corner, std::vector<ObjModel::Corner>& corners) {
    std::uint32_t& last = last_[corner.position];
    for (std::uint32_t at = last; at != ObjModel::none && at >= first_link_; at = links_[at].before) {
      const ObjModel::Corner& known = corners[links_[at].number];
      if (known.texture == corner.texture && known.normal == corner.normal) return links_[at].number;
    }
    const auto number = static_cast<std::uint32_t>(corners.size());
    corners.push_back(corner);
    links_.push_back({number, last});
    last = static_cast<std::uint32_t>(links_.size() - 1);
    return number;
  }

 private:
  struct Link {
    std::uint32_t number, before;
  };
  std::vector<std::uint32_t> last_;  ///< of each position
  std::vector<Link> links_;
  std::uint32_t first_link_ = 0;  ///< of the mesh
};

}  // namespace sturm
