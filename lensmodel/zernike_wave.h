#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "lensmodel/power_matrix.h"
#include "lensmodel/words.h"
#include "lensmodel/zernike.h"

namespace sturm {

/// How a wavefront's second-order power is taken.
enum class SecondOrder {
  LeastSquares,  ///< of the second-order coefficients at the pupil in use: the parabola nearest to the wave over that
                 ///< pupil
  Paraxial       ///< the wave's curvature at the pupil's centre, which higher orders change
};

inline constexpr Words<SecondOrder, 2> second_order_words{
    {{SecondOrder::LeastSquares, "least_squares"}, {SecondOrder::Paraxial, "paraxial"}}};  ///< in documents

/// A wavefront W over a disc as OSA/ANSI Zernike coefficients (docs/theory.md#52-measured-wavefronts). Wearer frame;
/// the ray through p leaves with the slope −∇W(p), so that a correcting power F alone is W = −½ pᵀF p. Immutable.
class ZernikeWave {
 public:
  /// `coefficients_m[j]` in the examiner's frame, single index j = (n(n + 2) + m)/2, normalised, [m], for the pupil
  /// radius [m]. Throws std::invalid_argument for a radius that is not positive, or more coefficients than order 20
  /// has.
  static ZernikeWave from_examiner(std::span<const double> coefficients_m, double radius_m);

  /// That of a correcting power over a pupil.
  static ZernikeWave of_power(const PowerMatrix& power, double radius_m);

  double radius_m() const { return radius_; }  ///< of the disc, > 0

  /// c_j in the wearer frame [m]; the last may be zero.
  const std::vector<double>& coefficients() const { return coefficients_; }

  /// The same wave described over a smaller pupil: exact (Dai 2006). Throws std::invalid_argument for a larger one.
  ZernikeWave rescaled(double radius_m) const;

  /// Both waves together; radii must be equal.
  ZernikeWave plus(const ZernikeWave& other) const;

  /// W [m] at the pupil point [m].
  double height(const Eigen::Vector2d& pupil_point) const;

  /// W [m] as a polynomial in x/radius where y/radius is given: its coefficients of x⁰, x¹, …
  std::vector<double> height_in_x(double y_of_radius) const { return height_.in_x(y_of_radius); }

  /// Slopes −∇W of the ray through the pupil point [m].
  Eigen::Vector2d slope(const Eigen::Vector2d& pupil_point) const;

  /// Correcting power F of second order [D].
  PowerMatrix power(SecondOrder rule) const;

  /// −∇W as polynomials in p/radius, for fast evaluation.
  const PlanePolynomial& slope_x() const { return slope_x_; }
  const PlanePolynomial& slope_y() const { return slope_y_; }  ///< the same along y

 private:
  ZernikeWave(std::vector<double> coefficients, double radius_m);

  std::vector<double> coefficients_;
  double radius_;
  PlanePolynomial height_, slope_x_, slope_y_;
};

}  // namespace sturm
