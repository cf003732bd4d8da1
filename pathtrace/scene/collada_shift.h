#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>

namespace sturm {

/// A COLLADA file whose geometries are moved to the origin, in double, so that they can be read in single precision.
struct ShiftedCollada {
  std::string text;
  std::map<std::string, Eigen::Vector3d> offsets;  ///< by the ids of geometries: what was taken from their positions
};

/// Moves each geometry by its first position. Those whose positions are no list of x y z stay where they are.
ShiftedCollada shifted_collada(const std::filesystem::path& file);

}  // namespace sturm
