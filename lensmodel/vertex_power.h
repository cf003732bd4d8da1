#pragma once
#include <optional>

#include "lensmodel/power_matrix.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// Powers of a lens about its axis, first order, light from outside [D]: wearer frame, oblique surfaces included.
struct VertexPower {
  PowerMatrix front, back;  ///< F₁ = (n − 1) H, F₂ = −(n − 1) H; H the Hessian of the surface's sag at its vertex
  std::optional<PowerMatrix>
      back_vertex;  ///< F₂ + F₁ (I − (t/n) F₁)⁻¹; none where a focal line of the front lies in the back vertex
};

VertexPower vertex_power(const Spectacles& lens);  ///< the lens alone: its distance from the eye does not count

}  // namespace sturm
