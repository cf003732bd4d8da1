#include "lensmodel/vertex_power.h"

#include <stdexcept>

namespace sturm {

namespace {

PowerMatrix power_of(const Surface& surface, double index_step) {
  const Eigen::Matrix2d bend = sag(surface, 0.0, 0.0).value().hessian;  // every surface has a vertex
  return PowerMatrix::from_components(index_step * bend(0, 0), index_step * bend(0, 1), index_step * bend(1, 1));
}

}  // namespace

VertexPower vertex_power(const Spectacles& lens) {
  const double excess = lens.refractive_index - 1.0;
  VertexPower power{power_of(lens.front, excess), power_of(lens.back, -excess), std::nullopt};
  try {
    power.back_vertex = power.back + power.front.moved_towards_eye(lens.center_thickness_m / lens.refractive_index);
  } catch (const std::domain_error&) {  // the back vertex lies at a focal line: there is no power to state
  }
  return power;
}

}  // namespace sturm
