#include <gtest/gtest.h>

#include "pathtrace/film/render.h"
#include "pathtrace/scene/texture.h"
#include "support/scenes.h"

namespace sturm {
namespace {

/// 2 × 2: upper row 0.1 0.2, lower row 0.3 0.4 in red.
Image four_texels() {
  Image image(2, 2, 3);
  image.at(0, 0)[0] = 0.1f;
  image.at(1, 0)[0] = 0.2f;
  image.at(0, 1)[0] = 0.3f;
  image.at(1, 1)[0] = 0.4f;
  return image;
}

TEST(Texture, VRunsUpwards) {
  const Image t = four_texels();
  EXPECT_EQ(texel(t, {0.2f, 0.2f}, true).x(), 0.3f);  // lower left
  EXPECT_EQ(texel(t, {0.8f, 0.2f}, true).x(), 0.4f);
  EXPECT_EQ(texel(t, {0.2f, 0.8f}, true).x(), 0.1f);
  EXPECT_EQ(texel(t, {0.8f, 0.8f}, true).x(), 0.2f);
}

TEST(Texture, IsClampedAtItsBorder) {
  const Image t = four_texels();
  for (bool nearest : {true, false}) {
    EXPECT_EQ(texel(t, {-3.0f, -3.0f}, nearest).x(), 0.3f);
    EXPECT_EQ(texel(t, {1.0f, 1.0f}, nearest).x(), 0.2f);
    EXPECT_EQ(texel(t, {1.0f, 0.0f}, nearest).x(), 0.4f);
  }
}

TEST(Texture, BilinearMeetsTexelCentresAndTheirMean) {
  const Image t = four_texels();
  EXPECT_NEAR(texel(t, {0.25f, 0.75f}, false).x(), 0.1f, 1e-7f);
  EXPECT_NEAR(texel(t, {0.5f, 0.5f}, false).x(), 0.25f, 1e-7f);
  EXPECT_NEAR(texel(t, {0.5f, 0.25f}, false).x(), 0.35f, 1e-7f);
}

TEST(Texture, LiesOnItsMeshTheRightWayUp) {
  SceneDescription description;
  description.materials = {testing::lambertian({1, 1, 1})};
  description.materials[0].albedo_texture = std::make_shared<Image>(four_texels());
  Mesh card = testing::parallelogram({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0);
  card.texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  description.meshes = {card};
  CameraPose pose;
  pose.vertical_field = 2.0 * std::atan(1.0);
  pose.width = pose.height = 4;
  RenderSettings settings;
  settings.samples_per_pixel = 16;
  const RenderResult result = render(Scene(description), EyeCamera(pose, testing::pinhole_rays()), settings);
  EXPECT_NEAR(result.albedo.at(0, 0)[0], 0.1f, 1e-6f);  // upper left of the picture is the first row of the texture
  EXPECT_NEAR(result.albedo.at(3, 0)[0], 0.2f, 1e-6f);
  EXPECT_NEAR(result.albedo.at(0, 3)[0], 0.3f, 1e-6f);
  EXPECT_NEAR(result.albedo.at(3, 3)[0], 0.4f, 1e-6f);
  EXPECT_NEAR(result.normal.at(1, 1)[2], 1.0f, 1e-6f);
}

}  // namespace
}  // namespace sturm
