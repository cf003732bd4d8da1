#pragma once
#include <Eigen/Core>

namespace sturm {

/// A map as a blur field stores it: xx, xy, yx, yy in single precision.
inline void store_rows(const Eigen::Matrix2d& m, float* rows) {
  rows[0] = static_cast<float>(m(0, 0));
  rows[1] = static_cast<float>(m(0, 1));
  rows[2] = static_cast<float>(m(1, 0));
  rows[3] = static_cast<float>(m(1, 1));
}

}  // namespace sturm
