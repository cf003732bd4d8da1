#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "compare/ellipses/bundle_moments.h"
#include "compare/ellipses/bundle_points.h"

namespace sturm {
namespace {

using testing::exact_disc, testing::mapped, testing::random_disc;

BundleMoments moments_of(const std::vector<Eigen::Vector2d>& points) {
  BundleMoments m;
  m.add(points);
  return m;
}

Eigen::Matrix2d skew_map() {
  Eigen::Matrix2d m;
  m << 2.0, -0.7, 0.4, 0.3;
  return m;
}

TEST(BundleMoments, FourCornersByHand) {
  // (±3, ±1) turned into a slanted set: (3, 1), (−3, −1), (1, 3), (−1, −3) about (10, −20)
  BundleMoments m;
  for (const Eigen::Vector2d& p :
       {Eigen::Vector2d(13, -19), Eigen::Vector2d(7, -21), Eigen::Vector2d(11, -17), Eigen::Vector2d(9, -23)})
    m.add(p);
  EXPECT_EQ(m.count(), 4u);
  EXPECT_NEAR((m.mean() - Eigen::Vector2d(10, -20)).norm(), 0.0, 1e-14);
  Eigen::Matrix2d expected;
  expected << 5, 3, 3, 5;
  EXPECT_NEAR((m.covariance(PointSet::LowDiscrepancy) - expected).norm(), 0.0, 1e-14);
  EXPECT_NEAR((m.covariance(PointSet::Independent) - expected * 4.0 / 3.0).norm(), 0.0, 1e-14);
  EXPECT_NEAR(*m.kurtosis({1, 0}), 41.0 / 25.0, 1e-14);                    // (81 + 81 + 1 + 1)/4 over 5²
  EXPECT_NEAR(*m.kurtosis({std::sqrt(0.5), std::sqrt(0.5)}), 1.0, 1e-14);  // ±√8 each: a two-point distribution
  EXPECT_NEAR(m.sampling_covariance()(1, 1), (9.0 - 9.0) / 4.0, 1e-14);    // dx·dy is 3 for all four points
  EXPECT_NEAR(m.sampling_covariance()(0, 2), (9.0 - 25.0) / 4.0, 1e-13);   // E[dx²dy²] = 9
}

TEST(BundleMoments, DiscHasKurtosisTwoInEveryDirectionOfEveryLinearImage) {
  const BundleMoments m = moments_of(mapped(skew_map(), exact_disc()));
  for (const double angle : {0.0, 0.4, 1.1, 2.9})
    EXPECT_NEAR(*m.kurtosis({std::cos(angle), std::sin(angle)}), 2.0, 1e-12);
  EXPECT_NEAR((m.covariance(PointSet::LowDiscrepancy) - 0.25 * skew_map() * skew_map().transpose()).norm(), 0.0, 1e-14);
}

TEST(BundleMoments, FarAwayPointsKeepTheirDigits) {
  const Eigen::Vector2d offset(1e6, -3e6);
  std::vector<Eigen::Vector2d> points = exact_disc();
  for (Eigen::Vector2d& p : points) p = offset + p;
  // Coordinates of 3e6 are rounded to 2e-10 when the points are made; Σx² − N x̄² would be wrong by 1e-3.
  EXPECT_NEAR((moments_of(points).covariance(PointSet::LowDiscrepancy) - 0.25 * Eigen::Matrix2d::Identity()).norm(),
              0.0, 1e-9);
}

TEST(BundleMoments, EqualPointsHaveNoWidthAtAll) {
  const BundleMoments m = moments_of(std::vector<Eigen::Vector2d>(5000, Eigen::Vector2d(0.1, 1e-3)));
  EXPECT_EQ(m.covariance(PointSet::LowDiscrepancy).norm(), 0.0);
  EXPECT_FALSE(m.kurtosis({1, 0}));
  EXPECT_FALSE(BundleMoments().kurtosis({1, 0}));
  EXPECT_EQ(BundleMoments().covariance(PointSet::Independent).norm(), 0.0);
}

RC_GTEST_PROP(BundleMoments, MergingIsTheSameAsAddingAll, ()) {
  const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  const std::size_t cut = *rc::gen::inRange<std::size_t>(0, 3001);
  const std::vector<Eigen::Vector2d> points = mapped(skew_map(), random_disc(3000, seed));
  const BundleMoments whole = moments_of(points);
  BundleMoments merged = moments_of({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(cut)});
  merged.merge(moments_of({points.begin() + static_cast<std::ptrdiff_t>(cut), points.end()}));
  BundleMoments one_by_one;
  for (const Eigen::Vector2d& p : points) one_by_one.add(p);
  for (const BundleMoments& m : {merged, one_by_one}) {
    // rounding of 3000 additions: √3000 ε, with room
    RC_ASSERT(m.count() == whole.count());
    RC_ASSERT((m.mean() - whole.mean()).norm() < 1e-14);
    RC_ASSERT((m.covariance(PointSet::Independent) - whole.covariance(PointSet::Independent)).norm() < 1e-13);
    RC_ASSERT((m.sampling_covariance() - whole.sampling_covariance()).norm() <
              1e-13 * whole.sampling_covariance().norm());
    RC_ASSERT(std::abs(*m.kurtosis({0.6, -0.8}) - *whole.kurtosis({0.6, -0.8})) < 1e-12);
  }
}

TEST(Summarise, StandardErrorIsTheScatterOverTheRootOfTheReplicates) {
  // Three replicates of a disc scaled by 1, 2, 3: variances 1/4, 1, 9/4; mean 7/6, scatter Σ(v − v̄)² = 49/24 …
  std::vector<BundleMoments> replicates;
  for (const double scale : {1.0, 2.0, 3.0}) {
    std::vector<Eigen::Vector2d> points = mapped(scale * Eigen::Matrix2d::Identity(), exact_disc());
    for (Eigen::Vector2d& p : points) p.x() += scale;  // centroids at 1, 2, 3
    replicates.push_back(moments_of(points));
  }
  const BundleEllipse e = summarise(replicates, PointSet::LowDiscrepancy);
  const double mean = 3.5 / 3.0;
  const double scatter = std::pow(0.25 - mean, 2) + std::pow(1.0 - mean, 2) + std::pow(2.25 - mean, 2);
  const double se = std::sqrt(scatter / (3.0 * 2.0));
  EXPECT_EQ(e.points, 48u);
  EXPECT_EQ(e.degrees_of_freedom, 2.0);
  EXPECT_NEAR(e.centroid.x(), 2.0, 1e-14);
  EXPECT_NEAR(e.centroid_standard_error->x(), std::sqrt(2.0 / 6.0), 1e-14);
  EXPECT_NEAR(e.covariance(0, 0), mean, 1e-14);
  EXPECT_NEAR((*e.covariance_standard_error())[0], se, 1e-14);
  EXPECT_NEAR((*e.covariance_standard_error())[1], 0.0, 1e-14);
  EXPECT_NEAR(*e.covariance_rel(), se / mean, 1e-13);  // both variances alike: √2 se over √2 mean
  EXPECT_NEAR(e.ellipse.semi_major, 2.0 * std::sqrt(mean), 1e-13);
  // 2(√(λ + se) − √λ) with λ = mean
  EXPECT_NEAR((*e.semi_axis_standard_errors())[1], 2.0 * (std::sqrt(mean + se) - std::sqrt(mean)), 1e-12);
}

TEST(Summarise, CovarianceRelCountsXyTwice) {
  std::vector<BundleMoments> replicates;
  for (const double shear : {0.8, 1.2}) {
    Eigen::Matrix2d map;
    map << 1.0, 0.0, shear, 1.0;  // yy and xy change, xx does not
    replicates.push_back(moments_of(mapped(map, exact_disc())));
  }
  const BundleEllipse e = summarise(replicates, PointSet::LowDiscrepancy);
  const double se_xy = 0.25 * 0.2, se_yy = 0.25 * 0.5 * (1.44 - 0.64);  // of two values: half their difference
  Eigen::Matrix2d mean;
  mean << 0.25, 0.25, 0.25, 0.25 * (1.0 + 0.5 * (1.44 + 0.64));
  EXPECT_NEAR(*e.covariance_rel(), std::sqrt(2.0 * se_xy * se_xy + se_yy * se_yy) / mean.norm(), 1e-13);
}

TEST(Summarise, OneReplicateFallsBackToTheKurtosisOrToNothing) {
  Eigen::Matrix2d stretch;
  stretch << 3.0, 0.0, 0.0, 1.0;
  const std::size_t n = 40000;
  const std::vector<BundleMoments> one{moments_of(mapped(stretch, random_disc(n, 5)))};
  EXPECT_FALSE(summarise(one, PointSet::LowDiscrepancy).entry_covariance);
  EXPECT_FALSE(summarise(one, PointSet::LowDiscrepancy).centroid_standard_error);
  EXPECT_FALSE(summarise(one, PointSet::LowDiscrepancy).semi_axis_standard_errors());
  const BundleEllipse e = summarise(one, PointSet::Independent);
  // A uniform disc has κ = 2: relative error 0.5/√N (docs/theory.md#71-from-a-bundle-of-rays); κ itself is known to 1 %
  // here, and the formula to O(1/√N)
  EXPECT_NEAR((*e.semi_axis_standard_errors())[0] / e.ellipse.semi_major * std::sqrt(n), 0.5, 0.01);
  EXPECT_NEAR((*e.semi_axis_standard_errors())[1] / e.ellipse.semi_minor * std::sqrt(n), 0.5, 0.01);
  EXPECT_NEAR(e.centroid_standard_error->x(), 1.5 / std::sqrt(n), 0.02 * 1.5 / std::sqrt(n));
}

TEST(Summarise, ReplicatesAndFourthMomentsTellTheSameStandardError) {
  std::vector<BundleMoments> replicates;
  for (std::uint64_t r = 0; r < 64; ++r)
    replicates.push_back(moments_of(mapped(skew_map(), random_disc(2000, 100 + r))));
  const Eigen::Vector3d from_scatter = *summarise(replicates, PointSet::Independent).covariance_standard_error();
  BundleMoments all;
  for (const BundleMoments& m : replicates) all.merge(m);
  const Eigen::Vector3d from_moments = *summarise(std::vector{all}, PointSet::Independent).covariance_standard_error();
  // a standard deviation from 64 values has a relative error of 1/√126 = 9 %; 4σ
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(from_scatter[i] / from_moments[i], 1.0, 0.36);
}

TEST(Summarise, UnbiasedForIndependentPoints) {
  // Tiny replicates make 1/N visible: dividing by N would lose a quarter of the variance.
  std::vector<BundleMoments> replicates;
  for (std::uint64_t r = 0; r < 4000; ++r) replicates.push_back(moments_of(random_disc(4, 900 + r)));
  const BundleEllipse e = summarise(replicates, PointSet::Independent);
  EXPECT_NEAR(e.covariance(0, 0), 0.25, 4.0 * (*e.covariance_standard_error())[0]);  // 4σ
  EXPECT_LT((*e.covariance_standard_error())[0], 0.25 / 4.0 / 10.0);  // …which is far smaller than the bias
}

TEST(Summarise, AnExactlyFlatBundleHasFiniteErrors) {
  Eigen::Matrix2d flat;
  flat << 1.0, 0.0, 0.0, 0.0;
  const BundleEllipse e = summarise(
      std::vector{moments_of(mapped(flat, random_disc(500, 1))), moments_of(mapped(flat, random_disc(500, 2)))},
      PointSet::Independent);
  EXPECT_EQ(e.ellipse.semi_minor, 0.0);
  EXPECT_EQ((*e.semi_axis_standard_errors())[1], 0.0);
  EXPECT_GT((*e.semi_axis_standard_errors())[0], 0.0);
}

TEST(Summarise, RefusesNothingAndReplicatesWithoutWidth) {
  EXPECT_THROW(summarise({}, PointSet::Independent), std::invalid_argument);
  EXPECT_THROW(summarise(std::vector{moments_of(random_disc(1, 1))}, PointSet::Independent), std::invalid_argument);
  EXPECT_THROW(summarise(std::vector{moments_of(random_disc(5, 1)), BundleMoments()}, PointSet::Independent),
               std::invalid_argument);
}

TEST(Summarise, ReplicatesOfDifferentSizeCountAlike) {  // a model may drop a ray here and there
  std::vector<Eigen::Vector2d> doubled = exact_disc();
  doubled.insert(doubled.end(), doubled.begin(), doubled.end());
  const BundleEllipse e =
      summarise(std::vector{moments_of(exact_disc()), moments_of(mapped(3.0 * Eigen::Matrix2d::Identity(), doubled))},
                PointSet::LowDiscrepancy);
  EXPECT_EQ(e.points, 48u);
  EXPECT_NEAR(e.covariance(0, 0), 0.5 * (0.25 + 2.25), 1e-14);
}

TEST(EllipseOfQuadrature, WeightsCount) {
  const std::vector<Eigen::Vector2d> points{{0, 0}, {4, 0}, {4, 2}};
  const std::vector<double> weights{2.0, 1.0, 1.0};  // centroid (2, 0.5); variances 4 and 0.75, covariance 1
  const BundleEllipse e = ellipse_of_quadrature(points, weights);
  EXPECT_NEAR((e.centroid - Eigen::Vector2d(2.0, 0.5)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(e.covariance(0, 0), 4.0, 1e-14);
  EXPECT_NEAR(e.covariance(0, 1), 1.0, 1e-14);
  EXPECT_NEAR(e.covariance(1, 1), 0.75, 1e-14);
  EXPECT_FALSE(e.entry_covariance);
  EXPECT_THROW(ellipse_of_quadrature(points, std::vector{1.0}), std::invalid_argument);
  EXPECT_THROW(ellipse_of_quadrature({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
