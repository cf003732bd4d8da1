#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/psf/circle_area.h"
#include "compare/psf/encircled_energy.h"
#include "compare/psf/pixel_light.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::pi;

/// Pixels of a Gaussian spot at `centre` [pixels], each with the light that falls on its area.
PointSpread gaussian(double sigma, const Eigen::Vector2d& centre, double side) {
  const auto light = [&](int pixel, double place) {
    const double a = (pixel - 0.5 - place) / (sigma * std::numbers::sqrt2),
                 b = (pixel + 0.5 - place) / (sigma * std::numbers::sqrt2);
    return 0.5 * (std::erf(b) - std::erf(a));
  };
  PointSpread spread;
  spread.cell_arcmin = side;
  const int reach = 4 + static_cast<int>(7.0 * sigma);
  double total = 0.0;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      spread.points.push_back(side * Eigen::Vector2d(x, y));
      spread.weights.push_back(light(x, centre.x()) * light(y, centre.y()));
      total += spread.weights.back();
    }
  for (double& weight : spread.weights) weight /= total;
  return spread;
}

TEST(CircleArea, OfASquareIsThatOfItsParts) {
  EXPECT_NEAR(area_within_circle({0.0, 0.0}, 2.0, 1.0), pi, 1e-14);  // the whole circle
  EXPECT_EQ(area_within_circle({3.0, -4.0}, 1.0, 20.0), 1.0);        // the whole square
  EXPECT_EQ(area_within_circle({3.0, -4.0}, 1.0, 4.0), 0.0);         // neither
  EXPECT_EQ(area_within_circle({0.0, 0.0}, 1.0, 0.0), 0.0);
  EXPECT_NEAR(area_within_circle({0.5, 0.5}, 1.0, 1.0), pi / 4.0, 1e-15);   // a quarter
  EXPECT_NEAR(area_within_circle({-1.0, 0.0}, 2.0, 1.0), pi / 2.0, 1e-14);  // a half
  // A cap of height ½ of the unit circle: acos ½ − ½ √(1 − ¼).
  EXPECT_NEAR(area_within_circle({2.5, 0.0}, 4.0, 1.0), pi / 3.0 - std::sqrt(3.0) / 4.0, 1e-14);
}

TEST(CircleArea, SquaresThatCoverACircleAddUp) {
  for (const double radius : {0.3, 1.7, 12.34}) {
    double sum = 0.0;
    for (int j = -20; j <= 20; ++j)
      for (int i = -20; i <= 20; ++i) sum += area_within_circle({0.7 * i + 0.21, 0.7 * j - 0.13}, 0.7, radius);
    EXPECT_NEAR(sum, pi * radius * radius, 1e-11);  // rounding of 1681 differences of areas of 150
  }
}

TEST(PixelLight, OfASmallGaussianDoesNotDependOnItsPlaceInThePixel) {
  // Pixels widen the spot to the variance σ² + 1/12.
  const double side = 0.7, width = side * std::sqrt(1.0 + 1.0 / 12.0);
  for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(0.5, 0.0),
                                        Eigen::Vector2d(0.2, -0.35), Eigen::Vector2d(-0.4, 0.1)}) {
    const PointSpread spot = gaussian(1.0, centre, side);
    const double r50 = width * std::sqrt(2.0 * std::log(2.0)), r80 = width * std::sqrt(2.0 * std::log(5.0));
    EXPECT_NEAR(encircled_energy_radius(spot, 0.5).value, r50, 0.005 * r50);
    EXPECT_NEAR(encircled_energy_radius(spot, 0.8).value, r80, 0.005 * r80);
    const double radii[] = {r50, r80};
    const auto curve = encircled_energy(spot, radii);
    EXPECT_NEAR(curve[0].value, 0.5, 0.004);  // dE = 2 ln 2 · ½ · 0.5 %
    EXPECT_NEAR(curve[1].value, 0.8, 0.004);
  }
}

/// Radius with the share `energy` of a Gaussian that is widened by a pixel of side 1, by summing rings of 1/2000 pixel.
double widened_radius(double sigma, double energy) {
  const auto along = [&](double x) {
    const double scale = sigma * std::numbers::sqrt2;
    return 0.5 * (std::erf((x + 0.5) / scale) - std::erf((x - 0.5) / scale));
  };
  constexpr double step = 5e-4;
  constexpr int angles = 64;
  double sum = 0.0, radius = 0.0;
  for (; sum < energy; radius += step)
    for (int k = 0; k < angles; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / angles, r = radius + 0.5 * step;
      sum += 2.0 * pi * r * step / angles * along(r * std::cos(angle)) * along(r * std::sin(angle));
    }
  return radius;
}

TEST(PixelLight, OfAGaussianThatIsSmallerThanItsPixels) {
  // The spline alone is wrong by 12 % at σ = 0.5 and by 42 % at σ = 0.3 where the spot lies on a corner of pixels.
  for (const double sigma : {0.3, 0.5, 0.7})
    for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.5, 0.5),
                                          Eigen::Vector2d(0.5, 0.0), Eigen::Vector2d(0.2, -0.35)}) {
      const PointSpread spot = gaussian(sigma, centre, 1.0);
      for (const double energy : {0.5, 0.8}) {
        const double expected = widened_radius(sigma, energy);
        // At σ = 0.3 a spot on a corner has but 0.3 % of its light outside of four equal pixels.
        EXPECT_NEAR(encircled_energy_radius(spot, energy).value, expected, (sigma < 0.4 ? 0.015 : 0.005) * expected)
            << sigma << " at " << centre.transpose();
      }
    }
}

TEST(PixelLight, OfASmallDisc) {
  // A disc of radius 2 pixels is no Gaussian. P(|p + u| < r) for p in the disc and u in a pixel, as the mean over u of
  // the area that two circles have in common, is 0.5 at r = 1.41448 and 0.8 at 1.85213.
  PointSpread spot;
  spot.cell_arcmin = 1.0;
  double total = 0.0;
  for (int y = -5; y <= 5; ++y)
    for (int x = -5; x <= 5; ++x) {
      int inside = 0;
      for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i)
          inside += Eigen::Vector2d(x + (i + 0.5) / 32 - 0.8, y + (j + 0.5) / 32 - 0.3).norm() < 2.0;
      spot.points.emplace_back(x, y);
      spot.weights.push_back(inside);
      total += inside;
    }
  for (double& weight : spot.weights) weight /= total;
  // Its edge has frequencies that pixels do not tell.
  EXPECT_NEAR(encircled_energy_radius(spot, 0.5).value, 1.41448, 0.03 * 1.41448);
  EXPECT_NEAR(encircled_energy_radius(spot, 0.8).value, 1.85213, 0.03 * 1.85213);
}

TEST(PixelLight, OfALargeSpotIsThatOfItsPoints) {
  const PointSpread spot = gaussian(6.0, {0.3, 0.1}, 1.0);
  const double expected = std::sqrt((36.0 + 1.0 / 12.0) * 2.0 * std::log(2.0));
  EXPECT_NEAR(encircled_energy_radius(spot, 0.5).value, expected, 1e-4 * expected);  // 8 parts: 1/(12·64·36)
  PointSpread points = spot;
  points.cell_arcmin = 0.0;
  EXPECT_NEAR(encircled_energy_radius(points, 0.5).value, expected, 0.02 * expected);  // rings of equal pixels
}

TEST(PixelLight, OfOnePixelIsAboutThatOfASquare) {
  PointSpread spot;
  spot.cell_arcmin = 2.0;
  spot.points = {{5.0, -7.0}};
  spot.weights = {1.0};
  // Evenly spread over the square: π r² = 4 · ½. The Gaussian is taken as 0.05 wide.
  EXPECT_NEAR(encircled_energy_radius(spot, 0.5).value, std::sqrt(2.0 / pi), 0.01 * std::sqrt(2.0 / pi));
  const double radii[] = {0.0, 1.0, 2.0, 50.0};
  const auto curve = encircled_energy(spot, radii);
  EXPECT_EQ(curve[0].value, 0.0);
  for (const WithError& e : curve) EXPECT_TRUE(e.value >= 0.0 && e.value <= 1.0);
  EXPECT_NEAR(curve[3].value, 1.0, 1e-12);
}

TEST(PixelLight, RadiusAndShareAreInverse) {
  const PointSpread spot = gaussian(2.0, {0.3, 0.4}, 1.5);
  const PixelLight light(spot);
  for (const double energy : {0.01, 0.1, 0.5, 0.8, 0.95, 0.999})
    EXPECT_NEAR(light.within(light.radius_of(energy)), energy, 1e-12);
}

}  // namespace
}  // namespace sturm
