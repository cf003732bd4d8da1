#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "lensmodel/ellipse.h"
#include "lensmodel/units.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

TEST(LineDirection, FoldsIntoTheHalfOpenInterval) {
  constexpr double pi = std::numbers::pi;
  EXPECT_DOUBLE_EQ(line_direction_deg(0.5 * pi), 90.0);
  EXPECT_DOUBLE_EQ(line_direction_deg(-0.5 * pi), 90.0);
  EXPECT_DOUBLE_EQ(line_direction_deg(1.5 * pi), 90.0);
  EXPECT_DOUBLE_EQ(line_direction_deg(pi), 0.0);
  EXPECT_DOUBLE_EQ(line_direction_deg(-pi / 6.0), -30.0);
  EXPECT_DOUBLE_EQ(line_direction_deg(5.0 * pi / 6.0), -30.0);
  EXPECT_DOUBLE_EQ(line_direction_deg(2.0 * pi / 3.0), -60.0);
}

TEST(SineCosine, ExactWhereAnAxisIsWrittenMostOften) {
  for (int k = -4; k <= 8; ++k) {
    const SineCosine sc = sine_cosine_of_degrees(90.0 * k);
    const int quarter = ((k % 4) + 4) % 4;
    EXPECT_EQ(sc.sine, quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0) << k;
    EXPECT_EQ(sc.cosine, quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0) << k;
    const SineCosine odd = sine_cosine_of_degrees(90.0 * k + 45.0);
    EXPECT_EQ(std::abs(odd.sine), std::abs(odd.cosine)) << k;
  }
}

RC_GTEST_PROP(SineCosine, AgreesWithTheLibrary, ()) {
  const double degrees = *rc::gen::inRange(-720000, 720001) * 1e-3;
  const long double radians = static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180.0L;
  const SineCosine sc = sine_cosine_of_degrees(degrees);
  RC_ASSERT(std::abs(static_cast<double>(sc.sine - std::sin(radians))) <= 3e-16);
  RC_ASSERT(std::abs(static_cast<double>(sc.cosine - std::cos(radians))) <= 3e-16);
}

TEST(Ellipse, OrientationIsSigned) {
  // A disc stretched 3 : 1 along the line from lower left to upper right, then mirrored.
  const auto stretched = [](double degrees) {
    const double t = degrees * radians_per_degree;
    Eigen::Matrix2d rotation;
    rotation << std::cos(t), -std::sin(t), std::sin(t), std::cos(t);
    return Eigen::Matrix2d(rotation * Eigen::Vector2d(3.0, 1.0).asDiagonal());
  };
  for (double degrees : {-89.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0}) {
    const Ellipse disc = Ellipse::image_of_disc(stretched(degrees), 2.0);
    EXPECT_NEAR(disc.semi_major, 6.0, 1e-14);
    EXPECT_NEAR(disc.semi_minor, 2.0, 1e-14);
    EXPECT_NEAR(std::remainder(*disc.orientation_deg - degrees, 180.0), 0.0, 1e-12);
    EXPECT_GT(*disc.orientation_deg, -90.0);
    EXPECT_LE(*disc.orientation_deg, 90.0);
    const Ellipse moments = Ellipse::of_second_moments(covariance_of_disc_image(stretched(degrees), 2.0));
    EXPECT_NEAR(moments.semi_major, 6.0, 1e-14);
    EXPECT_NEAR(moments.semi_minor, 2.0, 1e-13);
    EXPECT_NEAR(std::remainder(*moments.orientation_deg - degrees, 180.0), 0.0, 1e-12);
  }
}

TEST(Ellipse, ACircleAndAPointHaveNoOrientation) {
  EXPECT_FALSE(Ellipse::image_of_disc(2.0 * Eigen::Matrix2d::Identity(), 1.0).orientation_deg.has_value());
  EXPECT_FALSE(Ellipse::of_second_moments(Eigen::Matrix2d::Identity()).orientation_deg.has_value());
  EXPECT_FALSE(
      Ellipse::image_of_disc((Eigen::Matrix2d() << 1.0, 0.5, 0.5, 2.0).finished(), 0.0).orientation_deg.has_value());
}

TEST(Ellipse, CovarianceOfADiscImageByHand) {
  // X = [[2, 1], [0, 1]], a = 2: a²/4 X Xᵀ = [[5, 1], [1, 1]].
  const Eigen::Matrix2d c = covariance_of_disc_image((Eigen::Matrix2d() << 2.0, 1.0, 0.0, 1.0).finished(), 2.0);
  EXPECT_EQ(c, (Eigen::Matrix2d() << 5.0, 1.0, 1.0, 1.0).finished());
}

}  // namespace
}  // namespace sturm
