// Numberings of Zernike polynomials against the first rows of the tables of their authors, typed by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "lensmodel/zernike_order.h"
#include "lensmodel/zernike_wave.h"

namespace sturm {
namespace {

using Row = std::pair<int, int>;  // n, m; m < 0 is a sine

std::vector<Row> table_of(ZernikeOrder order, int last) {
  std::vector<Row> rows;
  for (int number = first_number(order); number <= last; ++number) {
    const ZernikeIndex index = zernike_index(order, number);
    rows.emplace_back(index.n, index.m);
  }
  return rows;
}

TEST(ZernikeOrder, NollsTable) {
  // Noll 1976, table I: even j are cosines.
  EXPECT_EQ(table_of(ZernikeOrder::Noll, 22),
            (std::vector<Row>{{0, 0},  {1, 1}, {1, -1}, {2, 0}, {2, -2}, {2, 2}, {3, -1}, {3, 1},
                              {3, -3}, {3, 3}, {4, 0},  {4, 2}, {4, -2}, {4, 4}, {4, -4}, {5, 1},
                              {5, -1}, {5, 3}, {5, -3}, {5, 5}, {5, -5}, {6, 0}}));
}

TEST(ZernikeOrder, FringesTable) {
  // The University of Arizona's set: tilt x, y, power, astigmatism 0, 45, coma x, y, spherical, trefoil …
  EXPECT_EQ(table_of(ZernikeOrder::Fringe, 37),
            (std::vector<Row>{{0, 0},  {1, 1},  {1, -1}, {2, 0},  {2, 2},  {2, -2}, {3, 1},  {3, -1}, {4, 0},  {3, 3},
                              {3, -3}, {4, 2},  {4, -2}, {5, 1},  {5, -1}, {6, 0},  {4, 4},  {4, -4}, {5, 3},  {5, -3},
                              {6, 2},  {6, -2}, {7, 1},  {7, -1}, {8, 0},  {5, 5},  {5, -5}, {6, 4},  {6, -4}, {7, 3},
                              {7, -3}, {8, 2},  {8, -2}, {9, 1},  {9, -1}, {10, 0}, {12, 0}}));
}

TEST(ZernikeOrder, EveryOrderNamesEveryPolynomialOnce) {
  for (const ZernikeOrder order : {ZernikeOrder::Osa, ZernikeOrder::Noll, ZernikeOrder::Fringe}) {
    std::set<Row> seen;
    for (const auto& [n, m] : table_of(order, last_number(order))) {
      EXPECT_EQ((n - m) % 2, 0);
      EXPECT_LE(std::abs(m), n);
      EXPECT_TRUE(seen.emplace(n, m).second) << n << " " << m;
    }
    EXPECT_THROW(zernike_index(order, first_number(order) - 1), std::invalid_argument);
    EXPECT_THROW(zernike_index(order, last_number(order) + 1), std::invalid_argument);
  }
}

TEST(ZernikeOrder, FringeCoefficientsAreHeightsAtTheRim) {
  // 1 of number 9 is 6r⁴ − 6r² + 1, which is Z₁₂/√5; number 8 is (3r³ − 2r) sin θ, Z₇/√8; number 4 is 2r² − 1, Z₄/√3.
  const std::vector<double> given = {0, 0, 0, 0.3, 0, 0, 0, 0.2, 0.1};
  const std::vector<double> osa = osa_coefficients(given, ZernikeOrder::Fringe, false);
  ASSERT_EQ(osa.size(), 13u);
  EXPECT_NEAR(osa[12], 0.1 / 2.23606797749979, 1e-16);
  EXPECT_NEAR(osa[7], 0.2 / 2.8284271247461903, 1e-16);
  EXPECT_NEAR(osa[4], 0.3 / 1.7320508075688772, 1e-16);
  // Heights on the rim, where cosine or sine is 1: at (0, 1), power, coma and spherical.
  const auto wave = ZernikeWave::from_examiner(osa, 1.0);
  EXPECT_NEAR(wave.height({0.0, 1.0}), 0.3 + 0.2 + 0.1, 1e-15);
  EXPECT_NEAR(wave.height({0.0, 0.0}), -0.3 + 0.1, 1e-15);
}

TEST(ZernikeOrder, TheSameNumberMeansAnotherAberration) {
  const std::vector<double> given = {0, 0, 0, 0, 0, 0, 1};  // Noll 7 and Fringe 7
  EXPECT_EQ(osa_coefficients(given, ZernikeOrder::Noll, true), (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(osa_coefficients(given, ZernikeOrder::Fringe, true), (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(ZernikeOrder, AMirrorTurnsXAround) {
  std::vector<double> c(28);
  for (std::size_t j = 0; j < c.size(); ++j) c[j] = 0.1 + 0.01 * static_cast<double>(j * j % 7);
  const auto wave = ZernikeWave::from_examiner(c, 2.0), other = ZernikeWave::from_examiner(mirrored(c), 2.0);
  for (const auto& [x, y] : {std::pair(0.3, 0.4), std::pair(-1.1, 0.9), std::pair(1.5, -0.2)})
    EXPECT_NEAR(other.height({x, y}), wave.height({-x, y}), 1e-13);
  EXPECT_EQ(mirrored(mirrored(c)), c);
}

}  // namespace
}  // namespace sturm
