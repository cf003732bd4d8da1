#pragma once
#include <cmath>
#include <numbers>

namespace sturm {

inline constexpr double metres_per_millimetre = 1e-3;                             ///< from millimetres to metres
inline constexpr double metres_per_micrometre = 1e-6;                             ///< from micrometres to metres
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;            ///< from degrees to radians
inline constexpr double arcminutes_per_radian = 60.0 * 180.0 / std::numbers::pi;  ///< from radians to minutes of arc

/// 1/d [D] of a distance > 0 [m]; 0 at infinity.
inline double vergence_of(double distance_m) {
  return 1.0 / distance_m;
}
/// Sine and cosine of one angle.
struct SineCosine {
  double sine, cosine;  ///< −1 … 1
};

/// Sine and cosine of an angle in degrees, exact at multiples of 90° and equal in size at odd multiples of 45°,
/// so that an AXIS of 90 or 180 gives true zeros in a power matrix.
inline SineCosine sine_cosine_of_degrees(double degrees) {
  const double folded = std::remainder(degrees, 360.0);                // exact, in [-180, 180]
  const double quarter = std::nearbyint(folded / 90.0);                // -2 … 2
  const double rest = (folded - 90.0 * quarter) * radians_per_degree;  // |rest| <= 45°
  double s = std::sin(rest), c = std::cos(rest);
  if (std::abs(folded - 90.0 * quarter) == 45.0) s = std::copysign(c = std::numbers::sqrt2 / 2.0, rest);
  switch ((static_cast<int>(quarter) + 4) % 4) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// Folds the direction of an undirected line from radians into degrees, (-90°, 90°].
inline double line_direction_deg(double radians) {
  double degrees = std::remainder(radians / radians_per_degree, 180.0);
  return degrees <= -90.0 ? degrees + 180.0 : degrees;
}

}  // namespace sturm
