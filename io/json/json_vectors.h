#pragma once
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "io/json/json.h"

namespace sturm {

/// [x, y, z] of a validated document.
inline Eigen::Vector3d read_vector3(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

}  // namespace sturm
