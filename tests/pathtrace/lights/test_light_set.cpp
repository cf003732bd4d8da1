#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "pathtrace/lights/light_set.h"
#include "pathtrace/sampling/owen_sobol.h"
#include "support/replicates.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::pi;
const Vector3f full(1.0f, 1.0f, 1.0f), either_side(0.0f, 0.0f, 0.0f);

struct Triangle {
  Vector3f a, b, c;
  Vector3f normal() const { return (b - a).cross(c - a).normalized(); }
};

const Triangle tilted{
    {-0.4f, 0.9f, 0.1f}, {0.7f, 1.0f, -0.3f}, {0.1f, 1.2f, 0.8f}};  // its normal has y < 0: it faces the origin
const Vector3f ball(0.5f, -1.0f, 1.5f);
constexpr float ball_radius = 0.6f;

/// Where the unit direction w from the origin meets the triangle (Cramer's rule in double).
std::optional<double> distance_to(const Triangle& t, const Vector3d& w) {
  Eigen::Matrix3d m;
  m << w, (t.a - t.b).cast<double>(), (t.a - t.c).cast<double>();
  const double det = m.col(0).dot(m.col(1).cross(m.col(2)));
  if (std::abs(det) < 1e-14) return std::nullopt;
  const Vector3d a = t.a.cast<double>();
  const double s = a.dot(m.col(1).cross(m.col(2))) / det;
  const double u = m.col(0).dot(a.cross(m.col(2))) / det, v = m.col(0).dot(m.col(1).cross(a)) / det;
  if (u < 0 || v < 0 || u + v > 1 || s <= 0) return std::nullopt;
  return s;
}

std::optional<double> distance_to_ball(const Vector3d& w) {
  const Vector3d c = ball.cast<double>();
  const double b = c.dot(w), discriminant = b * b - c.squaredNorm() +
                                            static_cast<double>(ball_radius) * static_cast<double>(ball_radius);
  if (b < 0 || discriminant < 0) return std::nullopt;
  return b - std::sqrt(discriminant);
}

// Midpoint rule over the whole sphere of directions; the boundary of the lights costs O(1/N) = a few 1e−4 with N = 1200
// × 2400.
TEST(LightSet, DensityIntegratesToOneOverAllDirections) {
  LightSet lights;
  const int triangle = lights.add_triangle(tilted.a, tilted.b, tilted.c, 3.0f * full);
  const int sphere = lights.add_sphere(ball, ball_radius, full);
  lights.finish();
  double total = 0.0;
  constexpr int rows = 1200, columns = 2400;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double z = -1.0 + 2.0 * (i + 0.5) / rows, phi = 2.0 * pi * (j + 0.5) / columns, s = std::sqrt(1.0 - z * z);
      const Vector3d w(s * std::cos(phi), s * std::sin(phi), z);
      const double solid_angle = 4.0 * pi / (static_cast<double>(rows) * columns);
      if (const auto t = distance_to(tilted, w))
        total += static_cast<double>(
                     lights.pdf(triangle, Vector3f::Zero(), either_side, (*t * w).cast<float>(), tilted.normal())) *
                 solid_angle;
      if (const auto t = distance_to_ball(w)) {
        const Vector3f at = (*t * w).cast<float>();
        total += static_cast<double>(lights.pdf(sphere, Vector3f::Zero(), either_side, at, (at - ball) / ball_radius)) *
                 solid_angle;
      }
    }
  EXPECT_NEAR(total, 1.0, 2e-3);
}

template <class Normal>
void expect_consistent(const LightSet& lights, const Vector3f& point, Normal&& normal_at) {
  int valid = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const auto u = owen_sobol::pair(i, 99);
    const LightSample s = lights.sample(point, either_side, unit_float(u.x), unit_float(u.y));
    if (!(s.pdf > 0.0f)) continue;
    ++valid;
    EXPECT_FALSE(s.delta);
    const Vector3f at = point + s.direction;
    // Float: the sampled point is rounded at 1e−7 of its distance, amplified by 1/cos at grazing angles.
    const float cosine = -normal_at(at).dot(s.direction.normalized());
    ASSERT_NEAR(lights.pdf(0, point, either_side, at, normal_at(at)) / s.pdf, 1.0f, 2e-5f / std::max(cosine, 0.02f))
        << i;
  }
  EXPECT_GT(valid, 4000);
}

TEST(LightSet, SampledDensityIsTheDensityOfTheSampledDirection) {
  LightSet triangle, sphere;
  triangle.add_triangle(tilted.a, tilted.b, tilted.c, full);
  triangle.finish();
  sphere.add_sphere(ball, ball_radius, full);
  sphere.finish();
  for (const Vector3f& point : {Vector3f(0, 0, 0), {0.3f, -0.5f, 0.2f}, {-2.0f, -1.0f, 0.5f}}) {
    expect_consistent(triangle, point, [](const Vector3f&) { return tilted.normal(); });
    expect_consistent(sphere, point, [](const Vector3f& at) { return Vector3f((at - ball).normalized()); });
  }
}

TEST(LightSet, SamplesLieOnTheLight) {
  LightSet sphere;
  sphere.add_sphere(ball, ball_radius, full);
  sphere.finish();
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto u = owen_sobol::pair(i, 7);
    const Vector3f at = sphere.sample(Vector3f::Zero(), either_side, unit_float(u.x), unit_float(u.y)).direction;
    EXPECT_NEAR((at - ball).norm(), ball_radius, 1e-3f);  // √ε of a float at the limb
    EXPECT_LE(at.norm(), std::sqrt(ball.squaredNorm() - ball_radius * ball_radius) + 1e-3f);  // on the near side
  }
}

// One unit of (u, v) area covers 1/pdf of solid angle, everywhere: no noise, no seed.
void expect_jacobian(const LightSet& lights, const Vector3f& point) {
  constexpr float h = 1.0f / 256.0f;
  for (float u : {0.15f, 0.4f, 0.6f, 0.85f})
    for (float v : {0.12f, 0.37f, 0.61f, 0.88f}) {
      const auto unit = [&](float a, float b) {
        return Vector3d(lights.sample(point, either_side, a, b).direction.cast<double>().normalized());
      };
      const Vector3d du = (unit(u + h, v) - unit(u - h, v)) / (2.0 * static_cast<double>(h));
      const Vector3d dv = (unit(u, v + h) - unit(u, v - h)) / (2.0 * static_cast<double>(h));
      // Truncation O(h²): (h/u)²/8 of the square root and (2πh)²/6 of the azimuth, up to 2e−4; rounding 1e−7/h = 3e−5.
      EXPECT_NEAR(du.cross(dv).norm() * static_cast<double>(lights.sample(point, either_side, u, v).pdf), 1.0, 1e-3)
          << u << " " << v;
    }
}

TEST(LightSet, JacobianOfASampleIsOneOverItsDensity) {
  LightSet triangle, sphere;
  triangle.add_triangle(tilted.a, tilted.b, tilted.c, full);
  triangle.finish();
  sphere.add_sphere(ball, ball_radius, full);
  sphere.finish();
  for (const Vector3f& point : {Vector3f(0, 0, 0), {0.3f, -0.5f, 0.2f}}) {
    expect_jacobian(triangle, point);
    expect_jacobian(sphere, point);
  }
  expect_jacobian(sphere, Vector3f(0.5f, -1.0f, 1.5f - 0.601f));  // 1 mm above the surface
}

TEST(LightSet, ADistantSphereKeepsItsDensity) {
  // Seen under 1e−4 rad, 1 − cos would cancel to nothing: solid angle π (R/d)².
  LightSet lights;
  lights.add_sphere({0, 0, 1000.0f}, 0.1f, full);
  lights.finish();
  EXPECT_NEAR(lights.sample(Vector3f::Zero(), either_side, 0.3f, 0.6f).pdf / (1.0 / (pi * 1e-8)), 1.0, 1e-5);
}

// Stratified u turns counting into quadrature: each frequency is exact to one count per slot.
TEST(LightSet, LightsAtOneDistanceAreChosenByPower) {
  LightSet lights;
  const std::vector<float> intensities{3.0f, 0.0f, 1.0f, 0.25f, 10.0f, 0.0f, 2.0f};
  double total = 0.0;
  for (std::size_t k = 0; k < intensities.size(); ++k) {
    const auto x = static_cast<float>(k);
    lights.add_point({x, 0.0f, std::sqrt(100.0f - x * x)}, intensities[k] * full);
    total += static_cast<double>(intensities[k]);
  }
  lights.finish();
  constexpr int n = 1 << 20;
  std::vector<int> counts(intensities.size(), 0);
  for (int i = 0; i < n; ++i) {
    const LightSample s = lights.sample(Vector3f::Zero(), either_side, (static_cast<float>(i) + 0.5f) / n, 0.5f);
    const auto k = static_cast<std::size_t>(std::lround(s.direction.x()));
    ++counts[k];
    ASSERT_TRUE(s.delta);
    ASSERT_NEAR(s.pdf, static_cast<double>(intensities[k]) / total, 1e-6);
  }
  for (std::size_t k = 0; k < counts.size(); ++k)
    EXPECT_NEAR(counts[k], n * static_cast<double>(intensities[k]) / total, 8.0) << k;
}

TEST(LightSet, IndependentChoicesPassChiSquared) {
  LightSet lights;
  for (int k = 0; k < 8; ++k) {
    const auto x = static_cast<float>(k);
    lights.add_point({x, 0.0f, std::sqrt(100.0f - x * x)}, (x + 1.0f) * full);
  }
  lights.finish();
  std::vector<int> counts(8, 0);
  constexpr int n = 1 << 16;
  for (std::uint32_t i = 0; i < n; ++i)
    ++counts[static_cast<std::size_t>(std::lround(
        lights.sample(Vector3f::Zero(), either_side, unit_float(owen_sobol::mixed(i)), 0.5f).direction.x()))];
  double sum = 0.0;
  for (int k = 0; k < 8; ++k)
    sum += std::pow(counts[static_cast<std::size_t>(k)] - n * (k + 1) / 36.0, 2) / (n * (k + 1) / 36.0);
  EXPECT_LT(sum, testing::chi_squared_limit(7));
}

TEST(LightSet, WhatIsLeftOfTheChoiceIsUniform) {
  // Two equal spheres side by side, one five times as bright: within each, the drop below the cone's axis is uniform in
  // u.
  LightSet lights;
  lights.add_sphere({-3.0f, 0, 10.0f}, 1.0f, full);
  lights.add_sphere({+3.0f, 0, 10.0f}, 1.0f, 5.0f * full);
  lights.finish();
  const Vector3f axes[] = {Vector3f(-3.0f, 0, 10.0f).normalized(), Vector3f(3.0f, 0, 10.0f).normalized()};
  const double cap = 1.0 - std::sqrt(1.0 - 1.0 / 109.0);
  std::vector<double> drops[2];
  for (int i = 0; i < (1 << 14); ++i) {
    const Vector3f w =
        lights.sample(Vector3f::Zero(), either_side, (static_cast<float>(i) + 0.5f) / (1 << 14), 0.3f).direction;
    const int k = w.x() > 0.0f;
    drops[k].push_back(0.5 * (w.cast<double>().normalized() - axes[k].cast<double>().normalized()).squaredNorm() / cap);
  }
  for (auto& d : drops) {
    std::sort(d.begin(), d.end());
    for (std::size_t i = 0; i < d.size(); ++i)
      ASSERT_NEAR(d[i], (static_cast<double>(i) + 0.5) / static_cast<double>(d.size()), 2e-3);
  }
}

TEST(LightSet, DarkLightsAloneDoNotDivideByZero) {
  LightSet lights;
  lights.add_point({1, 0, 0}, Vector3f::Zero());
  lights.add_point({2, 0, 0}, Vector3f::Zero());
  lights.finish();
  for (float u : {0.0f, 0.3f, 0.5f, 1.0f - 0x1p-24f}) {
    const LightSample s = lights.sample(Vector3f::Zero(), either_side, u, 0.5f);
    EXPECT_EQ(s.pdf, 0.0f);
  }
}

TEST(LightSet, NothingShinesFromTheBackOrTheInside) {
  LightSet lights;
  lights.add_triangle(tilted.a, tilted.b, tilted.c, full);
  lights.finish();
  const Vector3f behind(0.1f, 3.0f, 0.2f);
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto u = owen_sobol::pair(i, 5);
    const LightSample s = lights.sample(behind, either_side, unit_float(u.x), unit_float(u.y));
    EXPECT_EQ(s.pdf, 0.0f);
    EXPECT_EQ(lights.pdf(0, behind, either_side, behind + s.direction, tilted.normal()), 0.0f);
  }
  LightSet sphere;
  sphere.add_sphere(ball, ball_radius, full);
  sphere.finish();
  const Vector3f inside = ball + Vector3f(0.1f, 0.2f, 0.0f);
  EXPECT_EQ(sphere.sample(inside, either_side, 0.4f, 0.7f).pdf, 0.0f);
  EXPECT_EQ(sphere.pdf(0, inside, either_side, ball + Vector3f(ball_radius, 0, 0), Vector3f(1, 0, 0)), 0.0f);
}

}  // namespace
}  // namespace sturm
