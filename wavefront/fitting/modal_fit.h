#pragma once
#include <Eigen/Core>
#include <optional>
#include <stdexcept>
#include <vector>

namespace sturm {

/// A slope of a wavefront as a Shack–Hartmann sensor measures it, +∇W [rad] at a pupil point [m].
struct SlopeSample {
  Eigen::Vector2d point;
  Eigen::Vector2d slope;
};

/// A height W [m] of a wavefront at a pupil point [m].
struct HeightSample {
  Eigen::Vector2d point;
  double height;
};

/// A least-squares problem whose unknowns are OSA Zernike coefficients [m] of polynomials over a pupil, and whose rows
/// come in samples: a spot has two, a height one.
struct ModalProblem {
  std::vector<int> modes;  ///< OSA numbers, one for each column
  Eigen::MatrixXd design;
  Eigen::VectorXd values;
  int rows_per_sample;
  double negligible;  ///< a residual below this is never that of a spurious sample

  int samples() const { return static_cast<int>(values.size()) / rows_per_sample; }
};

/// The samples do not determine the modes.
class UndeterminedFit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Modes 1 … last of a radial order: no piston, which slopes do not see.
std::vector<int> modes_of_slopes(int radial_order);

/// Slopes as means over square lenslets of a side [m], exactly; 0: the gradient at the lenslet's centre.
ModalProblem slope_problem(const std::vector<SlopeSample>& samples, const std::vector<int>& modes, double pupil_radius,
                           double lenslet);

/// Heights at points. `modes` may contain 0.
ModalProblem height_problem(const std::vector<HeightSample>& samples, const std::vector<int>& modes,
                            double pupil_radius);

/// Zernike coefficients with their errors.
struct ModalFit {
  std::vector<int> modes;
  Eigen::VectorXd coefficients;     ///< [m]
  Eigen::MatrixXd unit_covariance;  ///< (GᵀG)⁻¹: times the variance of the noise, the covariance of the coefficients
  double condition_number;          ///< of G
  Eigen::VectorXd residuals;        ///< values − G c of all rows, those left out included
  std::vector<bool> used;           ///< of each sample; the others are spurious
  double residual_rms;              ///< of the used rows
  std::optional<double> noise;      ///< √(Σ r²/(rows − modes)) of the used rows; none without rows to spare
  std::optional<double> left_out_rms;  ///< of each sample predicted by the fit to all others; none where one alone
                                       ///< fixes a mode

  /// Standard error of the i-th coefficient for a standard deviation of the noise.
  double standard_error(int i, double noise_deviation) const;
};

/// Ordinary least squares by singular values over the samples that are `used`. Throws UndeterminedFit.
ModalFit fit_modes(const ModalProblem& problem, const std::vector<bool>& used);

/// Least squares without spurious samples: those that lie `spurious_distance` deviations or more from a fit that they
/// cannot pull far (least absolute residuals), and from the fit to the rest. Without such samples it is ordinary least
/// squares. Throws UndeterminedFit.
ModalFit fit_modes_robustly(const ModalProblem& problem);

inline constexpr double spurious_distance = 8.0;

}  // namespace sturm
