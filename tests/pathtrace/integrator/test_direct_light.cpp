// Direct light on a Lambertian floor (y = 0, albedo ρ) against closed forms: radiance = ρ/π · irradiance.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "pathtrace/film/render.h"
#include "support/lamp.h"
#include "support/replicates.h"
#include "support/scenes.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::pi;
const Vector3f albedo(0.8f, 0.4f, 0.1f);
const Vector3f radiance(5.0f, 3.0f, 2.0f);

/// Materials: 0 floor, 1 emitter, 2 black.
SceneDescription floor_scene() {
  SceneDescription description;
  description.materials = {testing::lambertian(albedo), testing::lambertian(Vector3f::Zero(), radiance),
                           testing::lambertian(Vector3f::Zero())};
  description.meshes = {testing::parallelogram({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}, 0)};  // normal +y
  return description;
}

testing::Estimate radiance_at(const Scene& scene, const Vector3d& point, int channel, int samples, int bounces = 1,
                              const Vector3d& eye = {1.7, 2.1, 2.9}) {
  std::vector<double> values;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    RenderSettings settings;
    settings.samples_per_pixel = samples;
    settings.max_bounces = bounces;
    settings.seed = seed;
    values.push_back(
        static_cast<double>(render(scene, testing::spot_meter(eye, point), settings).radiance.at(0, 0)[channel]));
  }
  return testing::Estimate::of(values);
}

/// 4 standard errors, and 1e−4 for two lengths over a distance of half a metre or more: the meter's field of 1e−5 rad
/// seen from 4 m (40 µm on the floor, centred), and the 15 µm by which a ray starts above the floor, twice for the
/// inverse square.
void expect_radiance(const Scene& scene, const Vector3d& point, const Vector3d& irradiance, const std::string& what,
                     int bounces = 1, const Vector3d& eye = {1.7, 2.1, 2.9}) {
  for (int k = 0; k < 3; ++k) {
    const testing::Estimate e = radiance_at(scene, point, k, 4096, bounces, eye);
    const double expected = static_cast<double>(albedo[k]) / pi * irradiance[k];
    EXPECT_NEAR(e.mean, expected, 4.0 * e.standard_error + 1e-4 * expected) << what << " channel " << k;
    EXPECT_LE(e.standard_error, 0.01 * expected) << what << " channel " << k;
  }
}

TEST(PointLight, InverseSquareAndCosine) {
  SceneDescription description = floor_scene();
  const Vector3f intensity(2.0f, 1.0f, 0.5f);
  description.lights = {{{0.3f, 1.5f, -0.4f}, intensity}};
  const Scene scene(description);
  for (const Vector3d& point : {Vector3d(0.3, 0, -0.4), {1.0, 0, 0.0}, {-2.0, 0, 1.0}}) {
    const Vector3d to_light = Vector3d(0.3, 1.5, -0.4) - point;
    const double cosine = to_light.normalized().y();
    expect_radiance(scene, point, intensity.cast<double>() * cosine / to_light.squaredNorm(), "point light");
  }
}

TEST(PointLight, CastsAShadowAndDoesNotShineThroughTheFloor) {
  SceneDescription description = floor_scene();
  description.lights = {{{0.0f, 2.0f, 0.0f}, {1, 1, 1}}};
  description.meshes.push_back(testing::parallelogram({-0.1f, 1.0f, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}, 2));
  const Scene scene(description);
  EXPECT_EQ(radiance_at(scene, {0.1, 0, 0.1}, 0, 16).mean, 0.0);  // the card's shadow reaches 0.2 m
  EXPECT_GT(radiance_at(scene, {0.25, 0, 0.1}, 0, 16).mean, 0.0);
  SceneDescription below = floor_scene();
  below.lights = {{{0.0f, -2.0f, 0.0f}, {1, 1, 1}}};
  EXPECT_EQ(radiance_at(Scene(below), {0.25, 0, 0.1}, 0, 16).mean, 0.0);
}

TEST(PointLight, LightsBothSidesOfAMesh) {
  SceneDescription description = floor_scene();
  description.lights = {{{0.0f, -2.0f, 0.0f}, {1, 1, 1}}};
  const testing::Estimate e = radiance_at(Scene(description), {0.0, 0, 0.0}, 0, 16, 1, {1.0, -2.0, 1.0});
  EXPECT_NEAR(e.mean, 0.8 / pi / 4.0, 1e-4 * 0.8 / pi / 4.0);
}

// A sphere wholly above the horizon: E = π L (R/d)² cos θ, exact at any size.
TEST(SphereLight, IrradianceOfASphere) {
  SceneDescription description = floor_scene();
  description.spheres = {{{0.0f, 0.8f, 0.0f}, 0.3f, 1}};
  const Scene scene(description);
  for (const Vector3d& point : {Vector3d(0, 0, 0), {0.5, 0, 0}, {0.7, 0, -0.9}}) {
    const Vector3d to_center = Vector3d(0.0, 0.8, 0.0) - point;
    const double e = pi * 0.09 / to_center.squaredNorm() * to_center.normalized().y();
    expect_radiance(scene, point, e * radiance.cast<double>(), "sphere");
  }
}

/// Lambert's formula: irradiance at `p`, normal n, of a polygon of unit radiance above the horizon, E = ½ Σ βᵢ γᵢ·n.
double polygon_irradiance(const Vector3d& p, const Vector3d& n, const std::vector<Vector3d>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d a = (corners[i] - p).normalized(), b = (corners[(i + 1) % corners.size()] - p).normalized();
    sum += std::acos(a.dot(b)) * a.cross(b).normalized().dot(n);
  }
  return std::abs(0.5 * sum);
}

TEST(AreaLight, LambertsFormulaAgreesWithTheTextbookRectangle) {
  // Element below the corner of a parallel rectangle with sides X = Y = h: F = 0.1385 (any table of configuration
  // factors).
  const std::vector<Vector3d> square{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
  const double x = 1.0 / std::sqrt(2.0);
  EXPECT_NEAR(polygon_irradiance({0, 0, 0}, {0, 1, 0}, square) / pi, 2.0 * x * std::atan(x) / (2.0 * pi), 1e-15);
  EXPECT_NEAR(polygon_irradiance({0, 0, 0}, {0, 1, 0}, square) / pi, 0.1385, 5e-5);
}

TEST(AreaLight, ParallelRectangle) {
  SceneDescription description = floor_scene();
  const Vector3f corner(-0.4f, 1.0f, -0.3f), width(1.0f, 0, 0), depth(0, 0, 0.7f);
  description.meshes.push_back(testing::parallelogram(corner, width, depth, 1));  // x × z = −y: emits downwards
  const Scene scene(description);
  const Vector3d c = corner.cast<double>(), w = width.cast<double>(), d = depth.cast<double>();
  for (const Vector3d& point : {Vector3d(0, 0, 0), {0.9, 0, 0.2}, {-1.5, 0, 1.5}})
    expect_radiance(scene, point,
                    polygon_irradiance(point, {0, 1, 0}, {c, c + w, c + w + d, c + d}) * radiance.cast<double>(),
                    "rectangle");
}

TEST(AreaLight, TiltedRectangleNearTheFloor) {
  SceneDescription description = floor_scene();
  const Vector3f corner(-0.5f, 0.02f, -0.2f), along(1.0f, 0.1f, 0), up(0, 0.5f, -0.4f);
  description.meshes.push_back(testing::parallelogram(corner, along, up, 1));  // normal towards +z and up
  const Scene scene(description);
  const Vector3d c = corner.cast<double>(), a = along.cast<double>(), u = up.cast<double>();
  for (const Vector3d& point : {Vector3d(0, 0, 0.1), {0.3, 0, 0.5}})
    expect_radiance(scene, point,
                    polygon_irradiance(point, {0, 1, 0}, {c, c + a, c + a + u, c + u}) * radiance.cast<double>(),
                    "tilted rectangle");
}

TEST(AreaLight, SeveralLightsAddUp) {
  SceneDescription description = floor_scene();
  description.materials.push_back(testing::lambertian(Vector3f::Zero(), 0.1f * radiance));
  description.meshes.push_back(testing::parallelogram({-0.4f, 1.0f, -0.3f}, {0.5f, 0, 0}, {0, 0, 0.5f}, 1));
  description.meshes.push_back(testing::parallelogram({-1.4f, 0.7f, -1.2f}, {0.9f, 0, 0}, {0, 0, 0.9f}, 3));
  description.spheres = {{{-1.0f, 0.5f, 0.5f}, 0.2f, 1}};
  description.lights = {{{0.2f, 2.0f, 1.0f}, {0.3f, 0.3f, 0.3f}}};
  const Scene scene(description);
  const Vector3d p(0.1, 0, 0.2), n(0, 1, 0), to_ball = Vector3d(-1.0, 0.5, 0.5) - p,
                                             to_point = Vector3d(0.2, 2.0, 1.0) - p;
  const double first = polygon_irradiance(p, n, {{-0.4, 1, -0.3}, {0.1, 1, -0.3}, {0.1, 1, 0.2}, {-0.4, 1, 0.2}});
  const double second =
      polygon_irradiance(p, n, {{-1.4, 0.7, -1.2}, {-0.5, 0.7, -1.2}, {-0.5, 0.7, -0.3}, {-1.4, 0.7, -0.3}});
  const double ball = pi * 0.04 / to_ball.squaredNorm() * to_ball.normalized().y();
  const double bulb = 0.3 * to_point.normalized().y() / to_point.squaredNorm();
  expect_radiance(scene, p, (first + 0.1 * second + ball) * radiance.cast<double>() + bulb * Vector3d::Ones(),
                  "four lights");
}

/// Irradiance of a convex lamp wholly above the horizon: its faces that look at the point hide nothing of each other.
double lamp_irradiance(const Vector3d& p, const Mesh& lamp) {
  double sum = 0.0;
  for (const auto& t : lamp.triangles) {
    const Vector3d a = lamp.positions[t[0]].cast<double>(), b = lamp.positions[t[1]].cast<double>(),
                   c = lamp.positions[t[2]].cast<double>();
    if ((b - a).cross(c - a).dot(p - a) > 0.0) sum += polygon_irradiance(p, {0, 1, 0}, {a, b, c});
  }
  return sum;
}

TEST(AreaLight, ARoundLampIsTheSumOfItsFaces) {
  SceneDescription description = floor_scene();
  const Mesh lamp = testing::round_lamp({0.2f, 0.5f, -0.1f}, 0.25f, 3, 1);
  description.meshes.push_back(lamp);
  const Scene scene(description);
  ASSERT_TRUE(scene.lights().groups().group(0).round);
  for (const Vector3d& point : {Vector3d(0.2, 0, -0.1), {0.6, 0, 0.2}, {-1.5, 0, 1.5}})
    expect_radiance(scene, point, lamp_irradiance(point, lamp) * radiance.cast<double>(), "round lamp");
}

TEST(AreaLight, ALampBesideAHiddenBrightOne) {
  // Near the point, and all that the choice of a light sees of brightness, stands a lamp behind a card.
  SceneDescription description = floor_scene();
  description.materials.push_back(testing::lambertian(Vector3f::Zero(), 10.0f * radiance));
  const Mesh hidden = testing::round_lamp({0.0f, 0.2f, 0.0f}, 0.05f, 3, 3),
             seen = testing::round_lamp({1.0f, 0.9f, 0.4f}, 0.1f, 3, 1);
  description.meshes.push_back(hidden);
  description.meshes.push_back(seen);
  description.meshes.push_back(testing::parallelogram({-0.1f, 0.1f, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}, 2));
  const Scene scene(description);
  const Vector3d p(0.05, 0, 0.02);
  EXPECT_EQ(radiance_at(Scene([&] {
                          SceneDescription d = description;
                          d.meshes.erase(d.meshes.begin() + 2);
                          return d;
                        }()),
                        p, 0, 16, 1, {0.05, 0.05, 0.5})
                .mean,
            0.0);
  expect_radiance(scene, p, lamp_irradiance(p, seen) * radiance.cast<double>(), "beside a hidden lamp", 1,
                  {0.05, 0.05, 0.5});
}

TEST(AreaLight, ALampBehindAnotherIsCountedOnce) {
  // Every direction in the cone of the round lamp meets a luminous panel first, which has its own samples.
  SceneDescription description = floor_scene();
  description.meshes.push_back(testing::round_lamp({0.0f, 0.2f, 0.0f}, 0.05f, 3, 1));
  description.meshes.push_back(
      testing::parallelogram({-0.1f, 0.1f, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}, 1));  // x × z = −y: shines down
  const Vector3d p(0.05, 0, 0.02);
  const double e =
      polygon_irradiance(p, {0, 1, 0}, {{-0.1, 0.1, -0.1}, {0.1, 0.1, -0.1}, {0.1, 0.1, 0.1}, {-0.1, 0.1, 0.1}});
  expect_radiance(Scene(description), p, e * radiance.cast<double>(), "lamp behind a panel", 1, {0.05, 0.05, 0.5});
}

TEST(SphereLight, FortyOfThemAddUp) {
  SceneDescription description = floor_scene();
  double e = 0.0;
  const Vector3d p(0.3, 0, 0.1);
  for (int k = 0; k < 40; ++k) {
    const Vector3f center(0.3f * static_cast<float>(k % 8) - 1.0f, 1.0f + 0.01f * static_cast<float>(k),
                          0.4f * static_cast<float>(k / 8) - 0.8f);
    description.spheres.push_back({center, 0.04f, 1});
    const Vector3d to_center = center.cast<double>() - p;
    e += pi * 0.0016 / to_center.squaredNorm() * to_center.normalized().y();
  }
  const Scene scene(description);
  ASSERT_GT(scene.lights().groups().size(), LightGroups::most_weighed);
  expect_radiance(scene, p, e * radiance.cast<double>(), "forty spheres", 1, {0.3, 0.2, 2.9});
}

TEST(AreaLight, EmitsFromTheSideItsWindingFaces) {
  SceneDescription description = floor_scene();
  description.meshes.push_back(
      testing::parallelogram({-0.5f, 1.0f, -0.5f}, {1.0f, 0, 0}, {0, 0, 1.0f}, 1));  // normal −y
  const Scene scene(description);
  EXPECT_EQ(radiance_at(scene, {0.1, 1.0, 0.1}, 0, 4, 0, {0.3, 0.2, 0.2}).mean, 5.0);  // from below
  EXPECT_EQ(radiance_at(scene, {0.1, 1.0, 0.1}, 0, 4, 0, {0.3, 3.0, 0.2}).mean, 0.0);  // from above
  // The floor beyond its plane gets nothing from its back.
  SceneDescription upwards = floor_scene();
  upwards.meshes.push_back(testing::parallelogram({-0.5f, 1.0f, -0.5f}, {0, 0, 1.0f}, {1.0f, 0, 0}, 1));  // normal +y
  EXPECT_EQ(radiance_at(Scene(upwards), {0.0, 0, 0.0}, 0, 64).mean, 0.0);
}

TEST(PathLength, NoBounceShowsEmittersOnly) {
  SceneDescription description = floor_scene();
  description.lights = {{{0.3f, 1.5f, -0.4f}, {1, 1, 1}}};
  EXPECT_EQ(radiance_at(Scene(description), {0, 0, 0}, 0, 4, 0).mean, 0.0);
}

}  // namespace
}  // namespace sturm
