// The environment map by itself: directions, density, and what it sends onto a floor.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pathtrace/film/render.h"
#include "pathtrace/lights/environment_map.h"
#include "support/replicates.h"
#include "support/scenes.h"
#include "support/units.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::pi;

/// A picture whose pixels `value(x, y)` gives.
template <class Value>
std::shared_ptr<const Image> picture(int width, int height, const Value& value) {
  auto image = std::make_shared<Image>(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int k = 0; k < 3; ++k) image->at(x, y)[k] = value(x, y)[k];
  return image;
}

const Vector3f one(1.0f, 1.0f, 1.0f);

TEST(EnvironmentMap, DirectionsOfThePicture) {
  // A pixel of its own colour each: column + 8 · row.
  const auto numbered =
      picture(8, 4, [](int x, int y) { return Vector3f(static_cast<float>(x), static_cast<float>(y), 0.0f); });
  const EnvironmentMap map(numbered, one, 0.0f);
  EXPECT_EQ(map.radiance({0.1f, 10.0f, 0.1f}).y(), 0.0f);   // up: top row
  EXPECT_EQ(map.radiance({0.1f, -10.0f, 0.1f}).y(), 3.0f);  // down: bottom row
  EXPECT_EQ(map.radiance({0.1f, 0.1f, -1.0f}).x(), 4.0f);   // ahead, a little to the right: right of the middle
  EXPECT_EQ(map.radiance({-0.1f, 0.1f, -1.0f}).x(), 3.0f);  // to the left
  EXPECT_EQ(map.radiance({1.0f, 0.1f, -0.1f}).x(), 5.0f);   // right: three quarters
  EXPECT_EQ(map.radiance({-0.1f, 0.1f, 1.0f}).x(), 0.0f);   // behind, left
  const EnvironmentMap turned(numbered, one, static_cast<float>(pi / 2));
  EXPECT_EQ(turned.radiance({1.0f, 0.1f, 0.1f}).x(), 4.0f);  // turned to the right: the middle is seen there
}

TEST(EnvironmentMap, SamplesHaveTheStatedDensityAndRadiance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0.0f, std::nextafter(1.0f, 0.0f));
  const auto noise = picture(
      16, 9, [&](int, int) { return Vector3f(uniform(random), uniform(random), std::pow(uniform(random), 8.0f)); });
  const EnvironmentMap map(noise, {1.0f, 2.0f, 3.0f}, 0.4f);
  // E[1/pdf] is the sphere's solid angle and E[L/pdf] the flux density, whatever the density is.
  constexpr int n = 1 << 18;
  double sphere = 0.0, green = 0.0, green_expected = 0.0;
  for (int i = 0; i < n; ++i) {
    const float u = uniform(random), v = uniform(random);
    const EnvironmentSample s = map.sample(u, v);
    ASSERT_NEAR(s.direction.norm(), 1.0f, 1e-5f);
    // A sample within rounding of a pixel's edge may be found on the other side of it.
    if (map.radiance(s.direction) == s.radiance) {
      ASSERT_EQ(map.pdf(s.direction), s.pdf);
    }
    sphere += 1.0 / static_cast<double>(s.pdf);
    green += static_cast<double>(s.radiance.y() / s.pdf);
  }
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 16; ++x)
      green_expected += 2.0 * static_cast<double>(noise->at(x, y)[1]) *
                        (std::cos(pi * y / 9) - std::cos(pi * (y + 1) / 9)) * 2.0 * pi / 16;
  EXPECT_NEAR(sphere / n, 4.0 * pi, 4.0 * pi * 0.01);             // 4σ; luminances differ by a factor of 2 or so
  EXPECT_NEAR(green / n, green_expected, green_expected * 2e-3);  // nearly constant weights
}

Scene floor_under(std::shared_ptr<const Image> map, const Vector3f& colour, float rotation = 0.0f) {
  SceneDescription description;
  description.materials = {testing::lambertian({0.5f, 0.5f, 0.5f})};
  description.meshes = {testing::parallelogram({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}, 0)};
  description.environment = Environment{colour, std::move(map), rotation};
  return Scene(description);
}

testing::Estimate floor_radiance(const Scene& scene) {
  std::vector<double> values;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    RenderSettings settings;
    settings.samples_per_pixel = 1024;
    settings.max_bounces = 1;
    settings.seed = seed;
    values.push_back(
        static_cast<double>(render(scene, testing::spot_meter({1, 2, 3}, {0, 0, 0}), settings).radiance.at(0, 0)[0]));
  }
  return testing::Estimate::of(values);
}

void expect_irradiance(const Scene& scene, double irradiance) {
  const testing::Estimate e = floor_radiance(scene);
  const double expected = 0.5 / pi * irradiance;
  EXPECT_NEAR(e.mean, expected, 4.0 * e.standard_error + 1e-5 * expected);  // rounding of float sums
  EXPECT_LE(e.standard_error, 0.01 * expected);
}

TEST(EnvironmentLight, ConstantSkyIsExact) {
  expect_irradiance(floor_under(nullptr, 3.0f * one), 3.0 * pi);
}

TEST(EnvironmentLight, HalfBrightSkies) {
  // The upper 60°: E = π sin² 60°. The half to the right: π/2, wherever it is turned. Only below the horizon: nothing.
  expect_irradiance(floor_under(picture(4, 90, [](int, int y) { return Vector3f(y < 30 ? one : 0.0f * one); }), one),
                    0.75 * pi);
  for (float rotation : {0.0f, 1.0f, -2.5f})
    expect_irradiance(
        floor_under(picture(4, 2, [](int x, int) { return Vector3f(x >= 2 ? one : 0.0f * one); }), one, rotation),
        0.5 * pi);
  EXPECT_EQ(
      floor_radiance(floor_under(picture(4, 2, [](int, int y) { return Vector3f(static_cast<float>(y) * one); }), one))
          .mean,
      0.0);
}

TEST(EnvironmentLight, IsSeenByTheCameraAndSharesTheChoicesWithLamps) {
  SceneDescription description;
  description.materials = {testing::lambertian({0.5f, 0.5f, 0.5f})};
  description.meshes = {testing::parallelogram({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}, 0)};
  description.environment = Environment{2.0f * one, picture(4, 2, [](int, int) { return one; }), 0.0f};
  description.lights = {{{0.0f, 2.0f, 0.0f}, {5.0f, 5.0f, 5.0f}}};
  const Scene scene(description);
  RenderSettings settings;
  settings.samples_per_pixel = 4;
  const RenderResult sky = render(scene, testing::spot_meter({0, 1, 0}, {0.3, 3, 0.2}), settings);
  EXPECT_EQ(sky.radiance.at(0, 0)[0], 2.0f);
  EXPECT_TRUE(std::isinf(*sky.depth.at(0, 0)));
  expect_irradiance(scene, 2.0 * pi + 5.0 / 4.0);
}

}  // namespace
}  // namespace sturm
