#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pathtrace/scene/obj/polygon_triangles.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const Polygon& polygon) {
  Triangles triangles;
  add_triangles_of(polygon, triangles);
  return triangles;
}

Vector3d area(const Polygon& polygon, const std::array<std::uint32_t, 3>& t) {
  return 0.5 * (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]);
}

/// Every triangle has the winding of the polygon, and their areas sum up to its own.
void expect_tiling(const Polygon& polygon, const Vector3d& whole) {
  const Triangles triangles = cut(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0.0;
  for (const auto& t : triangles) {
    EXPECT_GE(area(polygon, t).dot(whole), -1e-12);
    sum += area(polygon, t).norm();
  }
  EXPECT_NEAR(sum, whole.norm(), 1e-9);
}

TEST(PolygonTriangles, AConvexOneIsAFanAboutItsFirstCorner) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}}));
  Polygon ring;
  for (int i = 0; i < 7; ++i)
    ring.push_back({std::cos(2 * std::numbers::pi * i / 7), 2.0, std::sin(2 * std::numbers::pi * i / 7)});
  EXPECT_EQ(cut(ring).back(), (std::array<std::uint32_t, 3>{0, 5, 6}));
}

TEST(PolygonTriangles, OnesWithNotchesAreTiledFromAnyCorner) {
  const Polygon comb{{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {5, 4, 0}, {5, 1, 0}, {4, 1, 0},
                     {4, 4, 0}, {3, 4, 0}, {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};  // 6 + three teeth of 3
  for (std::size_t first = 0; first < comb.size(); ++first) {
    Polygon turned;
    for (std::size_t i = 0; i < comb.size(); ++i) turned.push_back(comb[(first + i) % comb.size()]);
    expect_tiling(turned, {0, 0, 15});
    std::reverse(turned.begin(), turned.end());
    expect_tiling(turned, {0, 0, -15});
  }
  Polygon star;  // ten corners, which wind round once; seen along x
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 ? 1.0 : 3.0, angle = std::numbers::pi * i / 5;
    star.push_back({7.0, r * std::cos(angle), r * std::sin(angle)});
  }
  expect_tiling(star, {10 * 0.5 * 3.0 * std::sin(std::numbers::pi / 5), 0, 0});
}

TEST(PolygonTriangles, ChevronsKeepTheirNotchOpen) {
  for (int first = 0; first < 4; ++first) {
    const Polygon chevron{{-1, -1, 0}, {0, 0, 0}, {1, -1, 0}, {0, 1, 0}};
    Polygon turned;
    for (int i = 0; i < 4; ++i) turned.push_back(chevron[static_cast<std::size_t>((first + i) % 4)]);
    expect_tiling(turned, {0, 0, 1});
  }
}

TEST(PolygonTriangles, DegenerateOnesAreCutSomehow) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2u);
  EXPECT_EQ(cut({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).size(), 3u);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);  // crosses itself
  Polygon twice;
  for (int i = 0; i < 10; ++i)
    twice.push_back({std::cos(4 * std::numbers::pi * i / 10), std::sin(4 * std::numbers::pi * i / 10), 0});
  EXPECT_EQ(cut(twice).size(), 8u);
}

}  // namespace
}  // namespace sturm
