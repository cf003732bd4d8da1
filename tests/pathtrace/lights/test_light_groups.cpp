// Which light is chosen where, and round lamps that are sampled in their cone.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "pathtrace/lights/light_set.h"
#include "pathtrace/sampling/owen_sobol.h"
#include "support/lamp.h"
#include "support/replicates.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
const Vector3f white(1.0f, 1.0f, 1.0f), any_side(0.0f, 0.0f, 0.0f), up(0.0f, 1.0f, 0.0f);

void add(LightSet& lights, const Mesh& mesh, const Vector3f& radiance) {
  for (const auto& t : mesh.triangles)
    lights.add_triangle(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], radiance);
}

/// A ceiling panel (normal −y) of two triangles, 1 × 1 m at height 2 m; a round lamp; a sphere; a point light.
LightSet four_groups() {
  LightSet lights;
  lights.add_triangle({0, 2, 0}, {1, 2, 0}, {1, 2, 1}, 2.0f * white);
  lights.add_triangle({0, 2, 0}, {1, 2, 1}, {0, 2, 1}, 2.0f * white);
  add(lights, testing::round_lamp({-1.0f, 0.8f, 0.3f}, 0.1f, 4, 0), 30.0f * white);
  lights.add_sphere({0.4f, 0.3f, -1.0f}, 0.05f, 50.0f * white);
  lights.add_point({2.0f, 1.0f, 1.0f}, white);
  lights.finish();
  return lights;
}

const std::vector<std::pair<Vector3f, Vector3f>> places{{{0, 0, 0}, up},
                                                        {{0, 0, 0}, any_side},
                                                        {{0.5f, 1.99f, 0.5f}, -up},
                                                        {{0.5f, 2.5f, 0.5f}, -up},
                                                        {{-0.85f, 0.8f, 0.3f}, {-1, 0, 0}},
                                                        {{5, 0, 0}, {-1, 0, 0}}};

TEST(LightGroups, TrianglesThatHangTogetherAreOneGroup) {
  const LightSet lights = four_groups();
  ASSERT_EQ(lights.groups().size(), 4);
  int round = 0;
  for (int g = 0; g < 4; ++g) round += lights.groups().group(g).round;
  EXPECT_EQ(round, 1);
  EXPECT_EQ(lights.groups().group_of(0), lights.groups().group_of(1));
  EXPECT_TRUE(lights.groups().group(lights.groups().group_of(2)).round);
}

TEST(LightGroups, TwoTrianglesThatCompleteEachOtherAreAParallelogram) {
  const LightSet lights = four_groups();
  EXPECT_TRUE(lights.groups().group(lights.groups().group_of(0)).parallelogram);
  LightSet kite, two_colours;
  kite.add_triangle({0, 2, 0}, {1, 2, 0}, {1, 2, 1}, white);
  kite.add_triangle({0, 2, 0}, {1, 2, 1}, {0, 2, 1.1f}, white);
  kite.finish();
  EXPECT_FALSE(kite.groups().group(0).parallelogram);
  two_colours.add_triangle({0, 2, 0}, {1, 2, 0}, {1, 2, 1}, white);
  two_colours.add_triangle({0, 2, 0}, {1, 2, 1}, {0, 2, 1}, 2.0f * white);
  two_colours.finish();
  EXPECT_FALSE(two_colours.groups().group(0).parallelogram);
}

// One unit of (u, v) area covers 1/pdf of solid angle, and a scattered ray to the same place is given the same density.
TEST(LightGroups, AParallelogramsSamplesHaveTheirDensity) {
  LightSet lights;
  const Vector3f a(-0.4f, 1.5f, 0.2f), b(0.6f, 1.4f, 0.1f), d(-0.5f, 1.7f, 1.0f),
      c = b + d - a, normal = (b - a).cross(d - a).normalized();
  const bool faces = normal.dot(a) < 0.0f;
  const Vector3f p = faces ? b : d, q = faces ? d : b, n = faces ? normal : Vector3f(-normal);
  lights.add_triangle(a, p, c, white);
  lights.add_triangle(a, c, q, white);
  lights.finish();
  ASSERT_TRUE(lights.groups().group(0).parallelogram);
  constexpr float h = 1.0f / 256.0f;
  for (float u : {0.1f, 0.5f, 0.9f})
    for (float v : {0.2f, 0.6f, 0.8f}) {
      const auto direction = [&](float x, float y) {
        return Vector3f(lights.sample({0, 0, 0}, any_side, x, y).direction);
      };
      const auto unit = [&](float x, float y) { return Vector3d(direction(x, y).cast<double>().normalized()); };
      const Vector3d du = (unit(u + h, v) - unit(u - h, v)) / (2.0 * static_cast<double>(h));
      const Vector3d dv = (unit(u, v + h) - unit(u, v - h)) / (2.0 * static_cast<double>(h));
      const float pdf = lights.sample({0, 0, 0}, any_side, u, v).pdf;
      EXPECT_NEAR(du.cross(dv).norm() * static_cast<double>(pdf), 1.0,
                  2e-4);  // O(h²) = 2e−5, and rounding 1e−7/h = 3e−5 twice
      for (int light : {0, 1})
        EXPECT_NEAR(lights.pdf(light, {0, 0, 0}, any_side, direction(u, v), n) / pdf, 1.0f, 1e-5f);
    }
}

TEST(LightGroups, ProbabilitiesSumToOne) {
  const LightSet lights = four_groups();
  for (const auto& [point, normal] : places) {
    double sum = 0.0;
    for (int g = 0; g < 4; ++g) sum += static_cast<double>(lights.groups().probability(g, point, normal));
    EXPECT_NEAR(sum, 1.0, 1e-6);  // four roundings of a float
  }
}

// Stratified u turns counting into quadrature: each frequency is exact to two counts.
TEST(LightGroups, FrequenciesAreTheProbabilitiesAndTheRestIsUniform) {
  const LightSet lights = four_groups();
  constexpr int n = 1 << 14;
  for (const auto& [point, normal] : places) {
    std::vector<int> counts(4, 0);
    std::vector<double> rests(4, 0.0);
    for (int i = 0; i < n; ++i) {
      const LightGroups::Choice c = lights.groups().choose(point, normal, (static_cast<float>(i) + 0.5f) / n);
      ASSERT_GT(c.probability, 0.0f);
      ASSERT_GE(c.rest, 0.0f);
      ASSERT_LT(c.rest, 1.0f);
      EXPECT_EQ(c.probability, lights.groups().probability(c.group, point, normal));
      ++counts[static_cast<std::size_t>(c.group)];
      rests[static_cast<std::size_t>(c.group)] += static_cast<double>(c.rest);
    }
    for (int g = 0; g < 4; ++g) {
      const int count = counts[static_cast<std::size_t>(g)];
      EXPECT_NEAR(count, n * static_cast<double>(lights.groups().probability(g, point, normal)), 2.0);
      // The mean of an equidistant grid is 1/2 but for one spacing.
      if (count > 0) {
        EXPECT_NEAR(rests[static_cast<std::size_t>(g)] / count, 0.5, 2.0 / count);
      }
    }
  }
}

TEST(LightGroups, IndependentChoicesPassChiSquared) {
  const LightSet lights = four_groups();
  constexpr int n = 1 << 16;
  for (const auto& [point, normal] : places) {
    std::vector<int> counts(4, 0);
    for (std::uint32_t i = 0; i < n; ++i)
      ++counts[static_cast<std::size_t>(lights.groups().choose(point, normal, unit_float(owen_sobol::mixed(i))).group)];
    double sum = 0.0;
    int bins = 0;
    for (int g = 0; g < 4; ++g) {
      const double expected = n * static_cast<double>(lights.groups().probability(g, point, normal));
      if (!(expected > 0.0)) {
        EXPECT_EQ(counts[static_cast<std::size_t>(g)], 0);
        continue;
      }
      ++bins;
      sum += std::pow(counts[static_cast<std::size_t>(g)] - expected, 2) / expected;
    }
    EXPECT_LE(sum, testing::chi_squared_limit(bins - 1));
  }
}

TEST(LightGroups, ChosenByIrradiance) {
  // Two equal small bulbs above a floor, straight up at 1 m and at 2 m: irradiances 4 : 1. A tenth goes by power, 1
  // : 1. 0.9 · 4/5 + 0.1 · 1/2 = 0.77. The bound of the cosine adds R/d to it: 1e−4 and half of that.
  LightSet heights;
  heights.add_sphere({0, 1, 0}, 1e-4f, white);
  heights.add_sphere({0, 2, 0}, 1e-4f, white);
  heights.finish();
  EXPECT_NEAR(heights.groups().probability(heights.groups().group_of(0), {0, 0, 0}, up), 0.77, 2e-5);
  // At one distance, at 0° and at 60° from the normal: 1 : 1/2, so 0.9 · 2/3 + 0.05 = 0.65; without a normal they are
  // equal.
  LightSet angles;
  angles.add_sphere({0, 1, 0}, 1e-4f, white);
  angles.add_sphere({0.86602540f, 0.5f, 0}, 1e-4f, white);
  angles.finish();
  EXPECT_NEAR(angles.groups().probability(angles.groups().group_of(0), {0, 0, 0}, up), 0.65, 2e-5);
  EXPECT_NEAR(angles.groups().probability(angles.groups().group_of(0), {0, 0, 0}, any_side), 0.5, 1e-6);
  // A panel of 1 cm² and radiance 4π·10⁴ that faces the point from 1 m sends as much as a point light of intensity 4π:
  // equal powers would be π L A = 4π² against 4π I = 16π², so 0.9/2 + 0.1/5 = 0.47. Its radius of 7 mm adds as much to
  // its cosine.
  const float radiance = 4e4f * std::numbers::pi_v<float>;
  LightSet panel;
  panel.add_triangle({-0.005f, 1, -0.005f}, {0.005f, 1, -0.005f}, {0.005f, 1, 0.005f}, radiance * white);
  panel.add_triangle({-0.005f, 1, -0.005f}, {0.005f, 1, 0.005f}, {-0.005f, 1, 0.005f}, radiance * white);
  panel.add_point({0.70710678f, 0.70710678f, 0},
                  4.0f * std::numbers::sqrt2_v<float> * std::numbers::pi_v<float> * white);
  panel.finish();
  // The point light stands at 45°: its intensity is larger by √2 in turn, and so is its power: 0.9/2 + 0.1/(1 + 4√2) =
  // 0.46502.
  EXPECT_NEAR(panel.groups().probability(panel.groups().group_of(0), {0, 0, 0}, up), 0.46502,
              0.9 * 0.25 * 0.0071 + 1e-4);
}

TEST(LightGroups, NothingIsChosenThatCannotShine) {
  const LightSet lights = four_groups();
  const int panel = lights.groups().group_of(0);
  EXPECT_EQ(lights.groups().probability(panel, {0.5f, 2.5f, 0.5f}, any_side), 0.0f);  // behind the panel
  EXPECT_EQ(lights.groups().probability(panel, {0, 3, 0}, up), 0.0f);
  EXPECT_EQ(lights.groups().choose({0, 3, 0}, up, 0.4f).probability, 0.0f);       // all lights are below
  EXPECT_GT(lights.groups().probability(panel, {0.5f, 1.999f, 0.5f}, up), 0.0f);  // 1 mm below, facing it
  EXPECT_GT(lights.groups().probability(panel, {0.0f, 1.9f, -0.2f}, Vector3f(0, 0.02f, -1).normalized()),
            0.0f);  // only its rim is above
}

TEST(LightGroups, ManyGroupsAreChosenByPower) {
  LightSet lights;
  for (int k = 0; k < 40; ++k) lights.add_point({static_cast<float>(k), 1, 0}, static_cast<float>(k + 1) * white);
  lights.finish();
  for (int k : {0, 7, 39}) EXPECT_NEAR(lights.groups().probability(k, {0, 0, 0}, up), (k + 1) / 820.0, 1e-7);
}

/// Directions and density of a round lamp alone.
TEST(LightGroups, DirectionsOfARoundLampFillItsConeEvenly) {
  LightSet lights;
  add(lights, testing::round_lamp({0.5f, 2.0f, -1.0f}, 0.4f, 4, 0), white);
  lights.finish();
  const Vector3d axis = Vector3d(0.5, 2.0, -1.0).normalized();
  const double cap = 1.0 - std::sqrt(1.0 - 0.16 / 5.25);
  constexpr int n = 1 << 14;
  std::vector<int> rings(16, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto u = owen_sobol::pair(i, 12);
    const LightSample s = lights.sample({0, 0, 0}, any_side, unit_float(u.x), unit_float(u.y));
    ASSERT_EQ(s.group, 0);
    ASSERT_NEAR(static_cast<double>(s.pdf) * 2.0 * std::numbers::pi * cap, 1.0,
                5e-5);  // the sphere's margin of 1e−5, twice
    const double drop = 1.0 - axis.dot(s.direction.cast<double>().normalized());
    // Equal solid angles between equal drops of the cosine.
    ++rings[std::min<std::size_t>(15, static_cast<std::size_t>(16.0 * std::max(0.0, drop) / cap))];
  }
  for (const int count : rings)
    EXPECT_NEAR(count, n / 16, 12);  // a (0,2)-sequence keeps its strata; rounding at the rings' edges
}

TEST(LightGroups, ARoundLampIsPutOnItsSamplesDensity) {
  LightSet lights = four_groups();
  for (const auto& [point, normal] : places) {
    for (std::uint32_t i = 0; i < 256; ++i) {
      const auto u = owen_sobol::pair(i, 3);
      const LightSample s = lights.sample(point, normal, unit_float(u.x), unit_float(u.y));
      if (s.group < 0) continue;
      const int light = lights.groups().group(s.group).lights.front();
      // Of whatever triangle the ray meets: the place on it does not matter.
      EXPECT_NEAR(lights.pdf(light, point, normal, point + s.direction, Vector3f(-s.direction)) / s.pdf, 1.0f, 1e-6f);
    }
  }
}

TEST(LightGroups, InsideItsSphereARoundLampIsSampledByArea) {
  LightSet lights;
  const Mesh lamp = testing::round_lamp({0, 0, 0}, 1.0f, 2, 0);
  add(lights, lamp, white);
  lights.finish();
  ASSERT_TRUE(lights.groups().group(0).round);
  // Just outside of a face, inside of the sphere.
  const auto& t = lamp.triangles.front();
  const Vector3f middle = (lamp.positions[t[0]] + lamp.positions[t[1]] + lamp.positions[t[2]]) / 3.0f,
                 point = 1.01f * middle;
  ASSERT_LT(point.norm(), 1.0f);
  int valid = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const auto u = owen_sobol::pair(i, 3);
    const LightSample s = lights.sample(point, middle.normalized(), unit_float(u.x), unit_float(u.y));
    EXPECT_LT(s.group, 0);
    valid += s.pdf > 0.0f;
  }
  EXPECT_GT(valid, 0);
}

}  // namespace
}  // namespace sturm
