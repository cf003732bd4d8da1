#pragma once

namespace sturm {

/// The reflectance of surfaces of a model file that states none, neither by a material nor by colours.
inline constexpr float unstated_reflectance = 0.6f;

}  // namespace sturm
