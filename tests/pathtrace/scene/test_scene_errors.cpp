#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "io/files/error.h"
#include "pathtrace/film/render.h"
#include "support/scenes.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

SceneDescription usable() {
  SceneDescription description;
  description.materials = {testing::lambertian({0.5f, 0.5f, 0.5f})};
  description.meshes = {testing::parallelogram({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0)};
  description.spheres = {{{0, 0, -2}, 0.5f, 0}};
  return description;
}

std::string message_of(const std::function<void(SceneDescription&)>& spoil) {
  SceneDescription description = usable();
  spoil(description);
  try {
    const Scene scene(description);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(SceneErrors, AUsableSceneIsAccepted) {
  EXPECT_NO_THROW(Scene{usable()});
}

TEST(SceneErrors, NumbersThatCannotBeTraced) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  for (float bad : {nan, infinite, -infinite, 2e6f}) {
    EXPECT_THAT(message_of([&](auto& d) { d.meshes[0].positions[1].y() = bad; }), HasSubstr("parallelogram")) << bad;
    EXPECT_THAT(message_of([&](auto& d) { d.spheres[0].center.x() = bad; }), HasSubstr("sphere")) << bad;
    EXPECT_THAT(message_of([&](auto& d) { d.spheres[0].radius = bad; }), HasSubstr("radius")) << bad;
  }
  EXPECT_THAT(message_of([](auto& d) { d.spheres[0].radius = 0.0f; }), HasSubstr("radius"));
  EXPECT_THAT(message_of([](auto& d) { d.spheres[0].radius = -1.0f; }), HasSubstr("radius"));
}

TEST(SceneErrors, IndicesOutOfRange) {
  EXPECT_THAT(message_of([](auto& d) { d.meshes[0].triangles[1][2] = 4; }),
              AllOf(HasSubstr("vertex index 4"), HasSubstr("less than 4")));
  EXPECT_THAT(message_of([](auto& d) { d.meshes[0].material = 1; }), HasSubstr("material 1"));
  EXPECT_THAT(message_of([](auto& d) { d.meshes[0].material = -1; }), HasSubstr("material -1"));
  EXPECT_THAT(message_of([](auto& d) { d.spheres[0].material = 7; }), HasSubstr("material 7"));
  EXPECT_THAT(message_of([](auto& d) { d.meshes[0].texture_coordinates.resize(3); }), HasSubstr("texture coordinates"));
}

TEST(SceneErrors, NothingToSee) {
  EXPECT_THAT(message_of([](auto& d) { d.meshes.clear(), d.spheres.clear(); }), HasSubstr("no surface"));
  EXPECT_THAT(message_of([](auto& d) { d.meshes[0].triangles.clear(), d.spheres.clear(); }), HasSubstr("no surface"));
}

TEST(SceneErrors, ASampleThatIsNotFiniteIsNamed) {
  SceneDescription description = usable();
  description.materials.push_back(testing::lambertian({0, 0, 0}, {1.0f, std::numeric_limits<float>::infinity(), 1.0f}));
  description.meshes = {testing::parallelogram({-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, 1)};
  const Scene scene(description);
  CameraPose pose;
  pose.width = pose.height = 1;
  RenderSettings settings;
  settings.seed = 77;
  settings.samples_per_pixel = 4;
  try {
    render(scene, EyeCamera(pose, testing::pinhole_rays()), settings);
    FAIL() << "expected a RuntimeFailure";
  } catch (const RuntimeFailure& failure) {
    EXPECT_THAT(failure.what(), AllOf(HasSubstr("pixel (0, 0)"), HasSubstr("sample 0"), HasSubstr("seed 77")));
  }
}

}  // namespace
}  // namespace sturm
