#include "lensmodel/focal_lines.h"

#include <cmath>
#include <limits>

#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

std::optional<double> FocalLine::distance_m() const {
  if (vergence_D < 0.0) return std::nullopt;
  return vergence_D == 0.0 ? std::numeric_limits<double>::infinity() : 1.0 / vergence_D;
}

std::array<FocalLine, 2> focal_lines(const Eigen::Matrix2d& curvature) {
  const PrincipalValues p = principal_values(curvature(0, 0), curvature(0, 1), curvature(1, 1));
  if (p.isotropic) return {FocalLine{p.high, std::nullopt}, FocalLine{p.low, std::nullopt}};
  const double across = std::atan2(p.high_direction.x(), -p.high_direction.y());  // a quarter turn further
  const double along = std::atan2(p.high_direction.y(), p.high_direction.x());
  return {FocalLine{p.high, line_direction_deg(across)}, FocalLine{p.low, line_direction_deg(along)}};
}

}  // namespace sturm
