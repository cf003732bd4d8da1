#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "compare/studies/sin2/closed_forms.h"

namespace sturm {
namespace {

/// The variances by brute force: the printed formula ray by ray, r² integrated by hand (mean a²/2).
Eigen::Matrix2d by_sums(const Eigen::Matrix2d& f, double target_vergence_D, double focus_m, double a) {
  constexpr int n = 200000;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int i = 0; i < n; ++i) {
    const double phi = 2.0 * std::numbers::pi * (i + 0.5) / n;
    const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
    const double power = e.dot(f * e), q = target_vergence_D - 1.0 / (focus_m + 1.0 / power);
    sum += q * q * e * e.transpose();
  }
  return 0.5 * a * a / n * sum;
}

TEST(MetalstigmatismClosedForm, IsTheMeanOfItsRays) {
  for (const Eigen::Matrix2d& f :
       {Eigen::Matrix2d{{3.0, 0.7}, {0.7, 2.0}}, Eigen::Matrix2d{{-4.0, -1.1}, {-1.1, -2.5}}})
    for (const double focus : {1.0, 0.4, 2.0})
      for (const double target : {0.0, 1.0, 2.5}) {
        const auto closed = metalstigmatism_covariance(f, target, focus, 2e-3);
        if (has_pole(f, focus)) {
          EXPECT_FALSE(closed);
          continue;
        }
        const Eigen::Matrix2d sums = by_sums(f, target, focus, 2e-3);
        EXPECT_LT((*closed - sums).norm(), 1e-11 * sums.norm())
            << f << " " << focus << " " << target;  // rounding of 2e5 terms
      }
}

TEST(MetalstigmatismClosedForm, OfASphereIsADiscWorkedByHand) {
  // −3 D at a focus of 1 m: slope +3/(1 − 3) = −1.5 D; seen from 1 m 1 − 1.5 = −0.5 D; from 0.5 m +0.5 D.
  const Eigen::Matrix2d f = -3.0 * Eigen::Matrix2d::Identity();
  for (const double target : {1.0, 2.0}) {
    const Eigen::Matrix2d c = *metalstigmatism_covariance(f, target, 1.0, 2e-3);
    EXPECT_NEAR(c(0, 0), 1e-6 * 0.25, 1e-20);
    EXPECT_NEAR(c(1, 1), 1e-6 * 0.25, 1e-20);
    EXPECT_EQ(c(0, 1), 0.0);
  }
  // Focused at infinity: parallel rays, whatever the eye.
  const Eigen::Matrix2d far = *metalstigmatism_covariance(f, 2.0, std::numeric_limits<double>::infinity(), 2e-3);
  EXPECT_NEAR(far(0, 0), 1e-6 * 4.0, 1e-20);
}

TEST(MetalstigmatismClosedForm, HasNoneAtThePole) {
  EXPECT_TRUE(has_pole(-Eigen::Matrix2d::Identity(), 1.0));
  EXPECT_TRUE(has_pole(Eigen::Matrix2d{{1.0, 0.0}, {0.0, -2.0}}, 1.0));
  EXPECT_FALSE(has_pole(Eigen::Matrix2d{{1.0, 0.0}, {0.0, -0.9}}, 1.0));
  EXPECT_FALSE(has_pole(Eigen::Matrix2d{{-3.0, 0.0}, {0.0, -2.0}}, 1.0));
  EXPECT_FALSE(has_pole(-Eigen::Matrix2d::Identity(), std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(metalstigmatism_covariance(-Eigen::Matrix2d::Identity(), 1.0, 1.0, 2e-3));
}

}  // namespace
}  // namespace sturm
