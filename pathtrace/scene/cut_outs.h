#pragma once
#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Triangles that rays may pass (Opacity). Only geometries that are attached here ask anything of a ray; all others
/// cost what they cost without.
///
/// A blended surface stops the share alpha of all rays: a number that is drawn from the ray's own bits and the triangle
/// decides, so that the same ray meets the same surfaces whenever, however and by whichever thread it is traced.
class CutOuts {
 public:
  /// Makes a geometry of these meshes' triangles, in their order, one that rays may pass. Call before it is committed;
  /// this object must outlive it, at its place.
  void attach(RTCGeometry geometry, const std::vector<const Mesh*>& meshes, const std::vector<Material>& materials);

 private:
  struct Triangle {
    std::array<Eigen::Vector2f, 3> coordinates;
    std::array<float, 3> alpha;  ///< of the vertices
    std::uint32_t surface;
  };
  struct Surface {
    Opacity opacity;
    bool nearest_filter;
  };
  struct Part {
    std::vector<Surface> surfaces;
    std::vector<Triangle> triangles;

    float alpha(const Triangle& triangle, float u, float v) const;
  };

  static void pass_rays(const RTCFilterFunctionNArguments* arguments);

  std::deque<Part> parts_;  ///< one for each geometry, which keeps its address
};

}  // namespace sturm
