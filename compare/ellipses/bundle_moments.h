#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "lensmodel/ellipse.h"

namespace sturm {

/// What a set of points is a sample of, which decides how its covariance is estimated without bias.
enum class PointSet {
  /// Independent points. The centroid that is subtracted was fitted to the same points and takes 1/N of the variance
  /// with it,
  /// so the sum of squares is divided by N − 1.
  Independent,
  /// Scrambled low-discrepancy points. Their centroid is off by O(N^-3/2) or so, not N^-1/2: it takes almost nothing
  /// away. Dividing
  /// by N − 1 would put in a bias of 1/N, which is larger than the standard error of such a set; so the divisor is N.
  LowDiscrepancy
};

/// Moments up to fourth order of a stream of 2-D points [any unit], in double, about the running mean. Merging is exact
/// up to rounding (Chan, Golub & LeVeque 1979; Pébay 2008 for the higher orders). The result depends on the order of
/// the calls.
class BundleMoments {
 public:
  void add(const Eigen::Vector2d& point);

  /// The same as adding one by one, but faster and with less rounding: two passes over each chunk, then a merge.
  void add(std::span<const Eigen::Vector2d> points);

  void merge(const BundleMoments& other);

  std::uint64_t count() const { return count_; }

  /// Centroid; zero for an empty bundle.
  Eigen::Vector2d mean() const { return mean_; }

  /// About the centroid [unit²]. Zero with fewer than two points.
  Eigen::Matrix2d covariance(PointSet kind) const;

  /// Kurtosis m₄/m₂² of the coordinate along `direction` (2 for a linear image of a uniform disc, 3 for a Gaussian);
  /// none where the points have no width along it.
  std::optional<double> kurtosis(const Eigen::Vector2d& direction) const;

  /// Covariance matrix of the estimates (xx, xy, yy) of `covariance` for independent points: (E[d_i d_j d_k d_l] − s_ij
  /// s_kl)/N, to first order in 1/N. For one axis this is s⁴(κ − 1)/N, so a semi-axis has the relative standard error
  /// 0.5·√((κ − 1)/N).
  Eigen::Matrix3d sampling_covariance() const;

 private:
  using CentralSums =
      std::array<std::array<double, 5>, 5>;  ///< [p][q] = Σ (x − x̄)^p (y − ȳ)^q for 2 ≤ p + q ≤ 4, the rest unused

  static BundleMoments of_chunk(std::span<const Eigen::Vector2d> points);

  std::uint64_t count_ = 0;
  Eigen::Vector2d mean_ = Eigen::Vector2d::Zero();
  CentralSums sums_{};
};

/// The ellipse of a ray bundle, measured by several replicates, with its standard errors. Units follow the points (u).
struct BundleEllipse {
  std::uint64_t points = 0;  ///< of all replicates
  int replicates = 0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< [u]
  Eigen::Matrix2d covariance =
      Eigen::Matrix2d::Zero();  ///< about the centroid of each replicate, mean over the replicates [u²]
  Ellipse ellipse;              ///< of second moments [u]
  std::optional<Eigen::Vector2d> centroid_standard_error;  ///< [u]
  /// Covariance matrix of the estimated entries (xx, xy, yy) [u⁴]; none where no replicate can tell.
  std::optional<Eigen::Matrix3d> entry_covariance;
  double degrees_of_freedom =
      0.0;  ///< of the standard errors: replicates − 1, or the number of points for a single replicate

  /// Standard errors of (xx, xy, yy) [u²].
  std::optional<Eigen::Vector3d> covariance_standard_error() const;

  /// √(Σ se²)/‖covariance‖_F, xy counted twice as in the Frobenius norm; none for a point.
  std::optional<double> covariance_rel() const;

  /// Standard errors of the semi-axes [u], (major, minor). From λ ± se(λ): 2(√(λ + se) − √λ), which is the usual se/√λ
  /// where λ ≫ se and stays finite where the bundle has no width.
  std::optional<Eigen::Vector2d> semi_axis_standard_errors() const;
};

/// Weights (for the entries xx, xy, yy) that give uᵀ Σ v of a symmetric Σ.
Eigen::Vector3d entry_weights(const Eigen::Vector2d& u, const Eigen::Vector2d& v);

/// Moments of one replicate, however its points were weighted.
struct ReplicateMoments {
  std::uint64_t points = 0;
  Eigen::Vector2d mean;
  Eigen::Matrix2d covariance;  ///< about the mean
};

/// Puts the replicates of one bundle together, each counting alike. The standard errors are the scatter between the
/// replicates divided by √R; a single replicate has none. Throws std::invalid_argument for an empty list.
BundleEllipse summarise(std::span<const ReplicateMoments> replicates);

/// Puts the replicates of one bundle together, each counting alike; they have at least two points, and all the same
/// number up to a few rays that a model could not launch. The standard errors are the scatter between the replicates
/// divided by √R. A single replicate of independent points falls back to its own fourth moments; a single
/// low-discrepancy replicate has no standard error. Throws std::invalid_argument for an empty list or a replicate of
/// fewer than two points.
BundleEllipse summarise(std::span<const BundleMoments> replicates, PointSet kind);

/// The ellipse of a quadrature rule: point i has the weight `weights[i]` > 0 (normalised here). It has no standard
/// error. Throws std::invalid_argument for lists of different length and for weights that do not add up to something
/// positive.
BundleEllipse ellipse_of_quadrature(std::span<const Eigen::Vector2d> points, std::span<const double> weights);

}  // namespace sturm
