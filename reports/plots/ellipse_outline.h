#pragma once
#include <Eigen/Core>
#include <string>

#include "lensmodel/ellipse.h"

namespace sturm {

/// Rows "x y" of a closed line around an ellipse that is drawn `scale` times as large about `centre`, and a blank row.
/// y is up, as in the wearer frame.
std::string ellipse_outline(const Ellipse& ellipse, const Eigen::Vector2d& centre, double scale);

}  // namespace sturm
