#include <gtest/gtest.h>

#include <cmath>

#include "compare/psf/distances.h"
#include "compare/psf/encircled_energy.h"
#include "compare/psf/point_spread.h"
#include "compare/psf/psf_comparison.h"
#include "compare/psf/transfer.h"
#include "compare/statistics/random_draws.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::pi;

constexpr double arcmin_rad = pi / (180.0 * 60.0);

PointSpread disc(double radius_arcmin, int count = 8000) {
  return spread_of_ellipse(radius_arcmin * arcmin_rad * Eigen::Matrix2d::Identity(), 1.0, count);
}

/// Independent rays, uniform over a disc of `radius` arcmin, mapped by `map`.
template <class Map>
PointSpread random_rays(int count, double radius, std::uint64_t seed, const Map& map) {
  std::vector<Eigen::Vector2d> angles;
  const auto uniform = [&] { return static_cast<double>(next_random(seed) >> 11) * 0x1p-53; };
  for (int i = 0; i < count; ++i) {
    const double r = radius * std::sqrt(uniform()), a = 2.0 * pi * uniform();
    angles.push_back(arcmin_rad * map(Eigen::Vector2d(r * std::cos(a), r * std::sin(a)), a));
  }
  return spread_of_rays(angles, true);
}
Eigen::Vector2d as_it_is(const Eigen::Vector2d& p, double) {
  return p;
}

double jinc(double x) {
  return x == 0.0 ? 1.0 : 2.0 * std::cyl_bessel_j(1, x) / x;
}

TEST(EncircledEnergy, OfADiscIsTheSquareOfTheRadius) {
  const double radii[] = {0.5, 1.0, 2.5, 4.0, 6.0};
  const auto curve = encircled_energy(disc(5.0), radii);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(curve[i].value, radii[i] * radii[i] / 25.0, 1e-3);  // O(1/√count) of points near the rim
  EXPECT_NEAR(curve[4].value, 1.0, 1e-12);
  EXPECT_FALSE(curve[0].standard_error);  // a sunflower is not random
  EXPECT_NEAR(encircled_energy_radius(disc(5.0), 0.5).value, 5.0 * std::sqrt(0.5), 2e-3);
  EXPECT_NEAR(encircled_energy_radius(disc(5.0), 0.8).value, 5.0 * std::sqrt(0.8), 2e-3);
}

TEST(EncircledEnergy, OfTheRoseOfSin2) {
  // Rays p ↦ r |cos 2φ|: the circle of least confusion. P(√u c ≤ ρ) = 1 − (2/π)(acos ρ − ρ√(1 − ρ²)).
  const PointSpread rose = random_rays(
      40000, 1.0, 5, [](const Eigen::Vector2d& p, double a) { return Eigen::Vector2d(std::cos(2.0 * a) * p); });
  const double radii[] = {0.2, 0.5, 0.8};
  const auto curve = encircled_energy(rose, radii);
  for (int i = 0; i < 3; ++i) {
    const double expected = 1.0 - 2.0 / pi * (std::acos(radii[i]) - radii[i] * std::sqrt(1.0 - radii[i] * radii[i]));
    EXPECT_NEAR(curve[i].value, expected, 4.0 * *curve[i].standard_error);  // 4σ
    EXPECT_NEAR(*curve[i].standard_error, std::sqrt(expected * (1.0 - expected) / 40000.0),
                0.05 * *curve[i].standard_error);
  }
}

TEST(EncircledEnergy, StandardErrorOfTheRadiusIsItsScatter) {
  // For a disc E = r²/R²: se(r) = √(E(1 − E)/N)·R/(2√E).
  const double expected = std::sqrt(0.25 / 2000.0) * 3.0 / (2.0 * std::sqrt(0.5));
  double mean = 0.0, squares = 0.0, stated = 0.0;
  constexpr int sets = 100;
  for (int s = 0; s < sets; ++s) {
    const WithError r = encircled_energy_radius(random_rays(2000, 3.0, 100 + s, as_it_is), 0.5);
    mean += r.value / sets, squares += r.value * r.value / sets, stated += *r.standard_error / sets;
  }
  EXPECT_NEAR(stated, expected, 0.05 * expected);
  EXPECT_NEAR(std::sqrt(squares - mean * mean), expected,
              4.0 * expected / std::sqrt(2.0 * sets));  // 4σ of a standard deviation
}

TEST(Transfer, OfADiscIsABesselFunctionInEveryDirection) {
  const PointSpread spread = disc(3.0);
  for (const double f : report_frequencies_cpd)
    for (const double direction : report_directions_deg)
      EXPECT_NEAR(modulation_transfer(spread, f, direction)->value, std::abs(jinc(2.0 * pi * 3.0 * f / 60.0)),
                  1e-3);  // O(1/√count)
}

TEST(Transfer, OfAFocalLineTellsTheDirections) {
  // A disc pressed flat along 45°: its projection on the line is that of the disc, across it a point.
  Eigen::Matrix2d flat;
  flat << 0.5, 0.5, 0.5, 0.5;
  const PointSpread line = spread_of_ellipse(4.0 * arcmin_rad * flat, 1.0, 20000);
  EXPECT_NEAR(modulation_transfer(line, 9.0, 45.0)->value, std::abs(jinc(2.0 * pi * 4.0 * 9.0 / 60.0)), 1e-3);
  EXPECT_NEAR(modulation_transfer(line, 9.0, 135.0)->value, 1.0, 1e-12);
}

TEST(Transfer, PhaseOfTheOtfIsAboutTheCentroidAndPixelsAreDividedOut) {
  // Light 3 : 1 on two points 2' apart: about the centroid (0.5' from the strong one) OTF = ¾ e^(+iπ f) + ¼ e^(−3iπ f),
  // f in cycles/arcmin.
  PointSpread pair;
  pair.points = {{7.0, 1.0}, {9.0, 1.0}};
  pair.weights = {0.75, 0.25};
  const double f = 0.2;
  const std::complex<double> expected = 0.75 * std::polar(1.0, pi * f) + 0.25 * std::polar(1.0, -3.0 * pi * f);
  EXPECT_NEAR(std::abs(optical_transfer(pair, 60.0 * f, 0.0) - expected), 0.0, 1e-12);
  pair.cell_arcmin = 1.0;
  EXPECT_FALSE(modulation_transfer(pair, 30.0, 0.0));  // half a cycle per pixel
  EXPECT_TRUE(modulation_transfer(pair, 29.0, 90.0));
  EXPECT_NEAR(std::abs(optical_transfer(pair, 60.0 * f, 0.0)), std::abs(expected) / (std::sin(pi * f) / (pi * f)),
              1e-12);
}

TEST(Transfer, StandardErrorIsTheScatter) {
  constexpr int sets = 200;
  double mean = 0.0, squares = 0.0, stated = 0.0;
  for (int s = 0; s < sets; ++s) {
    const WithError m = *modulation_transfer(random_rays(500, 2.0, 900 + s, as_it_is), 9.0, 0.0);
    mean += m.value / sets, squares += m.value * m.value / sets, stated += *m.standard_error / sets;
  }
  const double scatter = std::sqrt(squares - mean * mean);
  EXPECT_NEAR(scatter, stated, 4.0 * stated / std::sqrt(2.0 * sets));  // 4σ of a standard deviation
}

TEST(Wasserstein, OfShiftedCopies) {
  const PointSpread a = disc(2.0, 3000);
  PointSpread b = a;
  for (Eigen::Vector2d& p : b.points) p += Eigen::Vector2d(0.3, -0.4);
  EXPECT_NEAR(projected_wasserstein(a, b, {1.0, 0.0}), 0.3, 1e-12);
  EXPECT_NEAR(projected_wasserstein(a, b, {0.6, -0.8}), 0.5, 1e-12);
  EXPECT_NEAR(sliced_wasserstein(a, b, 128), 2.0 * 0.5 / pi, 1e-4);  // midpoint rule at the kinks of |cos|: O(1/128²)
  EXPECT_EQ(sliced_wasserstein(a, a), 0.0);
}

TEST(Wasserstein, OfDiscsOfDifferentSize) {
  // Projections are semicircles; sorted points pair up, so W₁ = |R₁ − R₂|·E|x| of the unit disc, E|x| = 4/(3π).
  EXPECT_NEAR(sliced_wasserstein(disc(3.0), disc(2.0, 6000), 16), 4.0 / (3.0 * pi), 1e-3);
}

TEST(TotalVariation, OfBoxesThatOverlap) {
  PointSpread a, b;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      a.points.emplace_back(i + 0.5, j + 0.5);
      b.points.emplace_back(i + 3.5, j + 0.5);
    }
  a.weights = b.weights = std::vector<double>(100, 0.01);
  EXPECT_NEAR(total_variation(a, b, 1.0).value, 0.3, 1e-12);
  EXPECT_NEAR(total_variation(a, b, 100.0).value, 0.0, 1e-12);
  EXPECT_FALSE(total_variation(a, b, 1.0).expected_of_noise);
}

TEST(TotalVariation, OfNoiseIsWhatIsExpected) {
  double value = 0.0, expected = 0.0;
  for (int s = 0; s < 20; ++s) {
    const TotalVariation t = total_variation(random_rays(20000, 5.0, 2 * s + 1, as_it_is),
                                             random_rays(30000, 5.0, 2 * s + 2, as_it_is), 1.0);
    value += t.value / 20, expected += *t.expected_of_noise / 20;
  }
  EXPECT_NEAR(value, expected, 0.05 * expected);  // 90 cells, 20 sets: 4 · 0.75/√1800 of half-normal deviates
}

TEST(PointSpread, OfAPictureIsSignedAndHasNoPixelVariance) {
  Image image(6, 4, 1);
  *image.at(4, 0) = 3.0f;  // right of and above the middle
  *image.at(5, 0) = 1.0f;
  const PointSpread spread = spread_of_image(image, 2.0);
  EXPECT_NEAR(spread.centroid().x(), 2.0 * (0.75 * 1.5 + 0.25 * 2.5), 1e-12);
  EXPECT_NEAR(spread.centroid().y(), 2.0 * 1.5, 1e-12);
  EXPECT_NEAR(spread.covariance()(0, 0), 4.0 * (0.1875 - 1.0 / 12.0), 1e-12);
  EXPECT_NEAR(spread.covariance()(1, 1), -4.0 / 12.0, 1e-12);
}

TEST(PointSpread, OfAnEllipseHasItsSecondMoments) {
  Eigen::Matrix2d map;
  map << 1.0, 0.4, -0.2, 0.5;
  const Eigen::Matrix2d expected = 0.25 * 9.0 * map * map.transpose();
  EXPECT_LT((spread_of_ellipse(arcmin_rad * map, 3.0, 20000).covariance() - expected).norm(),
            2e-4 * expected.norm());  // O(1/count)
}

TEST(PsfComparison, TellsADiscFromASmallerOne) {
  const PsfComparison c = compare_psfs(disc(3.0, 5000), disc(2.0, 5000), 0.5);
  EXPECT_NEAR(c.test.radius_50.value / c.reference.radius_50.value, 1.5, 1e-3);
  EXPECT_NEAR(c.sliced_wasserstein, 4.0 / (3.0 * pi), 1e-3);
  EXPECT_NEAR(c.total_variation.value, 1.0 - 4.0 / 9.0, 0.08);  // cells on the rims
  EXPECT_EQ(c.radii_arcmin.size(), 20u);
  EXPECT_NEAR(c.reference.encircled_energy[9].value, 0.5, 0.01);
}

}  // namespace
}  // namespace sturm
