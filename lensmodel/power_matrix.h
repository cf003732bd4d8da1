#pragma once
#include <Eigen/Core>
#include <optional>

#include "lensmodel/prescription.h"

namespace sturm {

/// Power vector of a thin lens [D]: spherical equivalent M and the two Jackson cross cylinders, examiner's frame.
/// Thibos, Wheeler & Horner 1997; docs/theory.md#2-from-a-prescription-to-a-power-matrix.
struct PowerVector {
  double M, J0, J45;  ///< [D]; S + C/2, −(C/2) cos 2α and −(C/2) sin 2α for S / C × α
};

PowerVector power_vector(const Prescription& rx);  ///< of the lens as written, at its own plane

/// Symmetric 2×2 dioptric power: maps a pupil offset [m] to the ray-slope change [rad] of a thin astigmatic lens.
/// Wearer frame (docs/theory.md#1-frames-signs-units): x to the wearer's right, y up. A cylinder has no power along its
/// axis and full power across it.
class PowerMatrix {
 public:
  PowerMatrix() : matrix_(Eigen::Matrix2d::Zero()) {}

  /// The lens as written, at its own plane (the vertex distance is not applied).
  static PowerMatrix from(const Prescription& rx);

  /// From the three numbers of a symmetric matrix in the wearer frame [D].
  static PowerMatrix from_components(double xx, double xy, double yy);

  static PowerMatrix scalar(double power_D) { return from_components(power_D, 0.0, power_D); }  ///< of a sphere [D]

  /// The same correction seen `distance_m` further along the light towards the eye: F (I − d F)⁻¹.
  /// Throws std::domain_error where I − d F is singular (the plane lies at a focal line of the lens).
  PowerMatrix moved_towards_eye(double distance_m) const;

  /// Slope [rad] that this power gives to the offset `pupil_point` [m].
  Eigen::Vector2d slope(const Eigen::Vector2d& pupil_point) const { return matrix_ * pupil_point; }

  /// Prescription in minus-cylinder form stated at this plane (vertex distance 0).
  Prescription as_prescription() const;

  double spherical_equivalent() const { return 0.5 * (matrix_(0, 0) + matrix_(1, 1)); }  ///< half of the trace [D]
  const Eigen::Matrix2d& matrix() const { return matrix_; }                              ///< [D], wearer frame
  double xx() const { return matrix_(0, 0); }                                            ///< from x to x [D]
  double xy() const { return matrix_(0, 1); }  ///< from y to x, and from x to y
  double yy() const { return matrix_(1, 1); }  ///< from y to y [D]

  friend PowerMatrix operator+(const PowerMatrix& a, const PowerMatrix& b) {
    return PowerMatrix(a.matrix_ + b.matrix_);
  }  ///< of two thin lenses in contact
  friend PowerMatrix operator-(const PowerMatrix& a, const PowerMatrix& b) {
    return PowerMatrix(a.matrix_ - b.matrix_);
  }  ///< what is left of the first without the second

 private:
  explicit PowerMatrix(const Eigen::Matrix2d& matrix) : matrix_(matrix) {}
  Eigen::Matrix2d matrix_;
};

/// The correcting power at the cornea of a prescription written for its vertex distance
/// (docs/theory.md#2-from-a-prescription-to-a-power-matrix).
PowerMatrix power_at_cornea(const Prescription& rx);

}  // namespace sturm
