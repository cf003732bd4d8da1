#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "compare/ellipses/bundle_points.h"
#include "compare/ellipses/ellipse_measures.h"
#include "compare/ellipses/ellipse_overlap.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::pi;

FilledEllipse ellipse(double p, double q, double degrees = 0.0,
                      const Eigen::Vector2d& centre = Eigen::Vector2d::Zero()) {
  const double a = degrees * pi / 180.0;
  FilledEllipse e{centre, {}};
  e.map << p * std::cos(a), -q * std::sin(a), p * std::sin(a), q * std::cos(a);
  return e;
}

TEST(EllipseOverlap, ConcentricInClosedForm) {
  // Unit circle and semi-axes p > 1 > q: the sector up to θ₀ is the circle's, the rest the ellipse's, ∫ r²/2 =
  // pq/2·atan((p/q) tan θ).
  for (const auto& [p, q] : {std::pair{2.0, 0.5}, {1.1, 0.9}, {30.0, 0.01}}) {
    const double angle = std::asin(std::sqrt(q * q * (p * p - 1.0) / (p * p - q * q)));
    const double expected = 2.0 * angle + 2.0 * p * q * (0.5 * pi - std::atan(p / q * std::tan(angle)));
    EXPECT_NEAR(common_area(ellipse(1, 1), ellipse(p, q, 33.0)), expected, 1e-11 * expected) << p;
    EXPECT_NEAR(common_area(ellipse(p, q, -70.0), ellipse(1, 1)), expected, 1e-10 * expected) << p;
  }
}

TEST(EllipseOverlap, OffsetCirclesInClosedForm) {
  for (const double d : {0.1, 1.0, 1.9}) {
    const double lens = 2.0 * std::acos(0.5 * d) - 0.5 * d * std::sqrt(4.0 - d * d);
    EXPECT_NEAR(common_area(ellipse(1, 1), ellipse(1, 1, 0.0, {0.6 * d, 0.8 * d})), lens, 1e-11) << d;
  }
}

TEST(EllipseOverlap, InsideApartAndDegenerate) {
  EXPECT_NEAR(common_area(ellipse(3, 2), ellipse(1, 0.5, 20.0, {0.5, 0.3})), 0.5 * pi, 1e-12);
  EXPECT_NEAR(common_area(ellipse(1, 0.5, 20.0, {0.5, 0.3}), ellipse(3, 2)), 0.5 * pi, 1e-12);
  EXPECT_EQ(common_area(ellipse(1, 1), ellipse(1, 1, 0.0, {3.0, 0.0})), 0.0);
  EXPECT_EQ(*intersection_over_union(ellipse(1, 0), ellipse(1, 1)), 0.0);  // a focal line covers nothing
  EXPECT_FALSE(intersection_over_union(ellipse(1, 0), ellipse(2, 0)));
  EXPECT_NEAR(*intersection_over_union(ellipse(2, 1, 15.0), ellipse(2, 1, 15.0)), 1.0, 1e-12);
  EXPECT_NEAR(*intersection_over_union(ellipse(1, 1), ellipse(1, 1, 0.0, {2.0, 0.0})), 0.0,
              1e-8);  // touching from outside: ε^(3/2) and the like
  EXPECT_NEAR(common_area(ellipse(2, 2), ellipse(1, 1, 0.0, {1.0, 0.0})), pi, 1e-8);  // touching from inside
}

RC_GTEST_PROP(EllipseOverlap, RatioIsInvariantUnderAffineMapsAndExchange, ()) {
  const auto number = [](int low, int high) { return 0.001 * *rc::gen::inRange(1000 * low, 1000 * high); };
  const FilledEllipse a = ellipse(number(1, 3), number(1, 3), number(0, 180)),
                      b = ellipse(number(1, 3), number(1, 3), number(0, 180), {number(-3, 3), number(-3, 3)});
  Eigen::Matrix2d m;
  m << number(1, 2), number(-1, 1), number(-1, 1), -number(2, 4);
  RC_PRE(std::abs(m.determinant()) > 0.5);
  const FilledEllipse c{m * a.centre, m * a.map}, d{m * b.centre, m * b.map};
  const double ratio = *intersection_over_union(a, b);
  RC_ASSERT(ratio >= 0.0 && ratio <= 1.0 + 1e-12);
  RC_ASSERT(std::abs(ratio - *intersection_over_union(c, d)) <
            1e-7);  // ε^(3/2) where they touch, times the condition of the map
  RC_ASSERT(std::abs(ratio - *intersection_over_union(b, a)) < 1e-7);
  FilledEllipse mirrored = b;  // the same ellipse, run through the other way round
  mirrored.map.col(1) *= -1.0;
  RC_ASSERT(std::abs(ratio - *intersection_over_union(a, mirrored)) < 1e-12);
}

/// Bundle of `rays` independent points of the ellipse with semi-axes 3 and 2 at 25°.
BundleEllipse random_bundle(int rays, int seed) {
  Eigen::Matrix2d map;
  const double c = 0.9063077870366499, s = 0.42261826174069944;  // cos, sin of 25°
  map << 3.0 * c, -2.0 * s, 3.0 * s, 2.0 * c;
  BundleMoments moments;
  moments.add(testing::mapped(map, testing::random_disc(rays, seed)));
  return summarise(std::vector<BundleMoments>{moments}, PointSet::Independent);
}
Eigen::Matrix2d true_moments() {
  Eigen::Matrix2d m;
  const double c = 0.9063077870366499, s = 0.42261826174069944;
  m << 9.0 * c * c + 4.0 * s * s, 5.0 * c * s, 5.0 * c * s, 9.0 * s * s + 4.0 * c * c;
  return 0.25 * m;
}

TEST(EllipseMeasures, StandardErrorsAreTheScatter) {
  constexpr int sets = 200;
  struct Sum {
    double mean = 0.0, squares = 0.0, stated = 0.0;
    void add(const EllipseMeasure& m) {
      mean += m.value / sets, squares += m.value * m.value / sets, stated += *m.standard_error / sets;
    }
    double scatter() const { return std::sqrt(squares - mean * mean); }
  } major, minor, angle, area;
  double frobenius_z = 0.0, overlap_z = 0.0;
  for (int s = 0; s < sets; ++s) {
    const EllipseMeasures m =
        measure_ellipses(random_bundle(1000, 1000 + s), true_moments(), Eigen::Vector2d::Zero(), 7, 64);
    major.add(m.semi_major), minor.add(m.semi_minor), angle.add(*m.orientation), area.add(*m.log_area_ratio);
    frobenius_z += *m.frobenius.z / sets, overlap_z += *m.missing_overlap->z / sets;
  }
  // 4σ of a standard deviation from 200 sets, plus 2 % of second order in 1/√1000.
  for (const Sum& s : {major, minor, angle, area})
    EXPECT_NEAR(s.scatter() / s.stated, 1.0, 4.0 / std::sqrt(2.0 * sets) + 0.02);
  // κ = 2: relative 0.5/√N of a semi-axis, 1/√(2N)… of the log area: ½·√(Var x² + Var y² + 2 Cov) = ½·√((1 + 1 −
  // 2/3)/N).
  EXPECT_NEAR(major.stated, 3.0 * 0.5 / std::sqrt(1000.0), 0.02 * major.stated);
  EXPECT_NEAR(area.stated, 0.5 * std::sqrt(4.0 / 3.0 / 1000.0), 0.02 * area.stated);
  EXPECT_NEAR(frobenius_z, 0.0,
              4.0 * 1.1 / std::sqrt(1.0 * sets));  // noise alone has a z about 0; 64 draws add to its scatter
  EXPECT_NEAR(overlap_z, 0.0, 4.0 * 1.1 / std::sqrt(1.0 * sets));
}

TEST(EllipseMeasures, SignedAndFarFromTheWrongPrediction) {
  Eigen::Matrix2d turned = true_moments();
  turned(0, 1) = turned(1, 0) = -turned(1, 0);  // −25°
  const EllipseMeasures m = measure_ellipses(random_bundle(4000, 3), turned);
  EXPECT_NEAR(m.orientation->value, 50.0, 4.0 * *m.orientation->standard_error);
  EXPECT_GT(*m.orientation->z, 20.0);
  EXPECT_GT(*m.frobenius.z, 20.0);
  EXPECT_GT(*m.missing_overlap->z, 20.0);
  const EllipseMeasures smaller = measure_ellipses(random_bundle(4000, 3), 1.44 * true_moments());
  EXPECT_NEAR(smaller.log_area_ratio->value, -std::log(1.44), 4.0 * *smaller.log_area_ratio->standard_error);
  EXPECT_NEAR(smaller.missing_overlap->value, 1.0 - 1.0 / 1.44,
              4.0 * *smaller.missing_overlap->standard_error + 0.01);  // overlap of similar ellipses
}

TEST(EllipseMeasures, WhatCannotBeToldIsNone) {
  BundleEllipse exact;  // no standard error
  exact.covariance = true_moments();
  exact.ellipse = Ellipse::of_second_moments(exact.covariance);
  const EllipseMeasures m = measure_ellipses(exact, true_moments());
  EXPECT_FALSE(m.semi_major.z);
  EXPECT_FALSE(m.frobenius.standard_error);
  EXPECT_NEAR(m.missing_overlap->value, 0.0, 1e-12);
  const EllipseMeasures circle = measure_ellipses(exact, Eigen::Matrix2d::Identity());
  EXPECT_FALSE(circle.orientation);
  EXPECT_FALSE(measure_ellipses(exact, Eigen::Matrix2d::Zero()).log_area_ratio);
}

TEST(EllipseMeasures, RoundingOfAFocalLineIsNoDifference) {
  Eigen::Matrix2d line;  // a disc pressed flat along 30°
  const double c = 0.8660254037844386, s = 0.5;
  line << c * c, c * s, c * s, s * s;
  BundleMoments moments;
  moments.add(testing::mapped(line, testing::random_disc(4000, 11)));
  const EllipseMeasures m = measure_ellipses(summarise(std::vector<BundleMoments>{moments}, PointSet::Independent),
                                             0.25 * line * line.transpose());
  EXPECT_LT(std::abs(*m.semi_minor.z), 1.0);
  EXPECT_LT(std::abs(*m.semi_major.z), 4.0);
  EXPECT_FALSE(m.log_area_ratio);  // no area to compare
  EXPECT_FALSE(m.missing_overlap);
}

}  // namespace
}  // namespace sturm
