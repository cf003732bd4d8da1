#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "stages/page/undrawn.h"
#include "stages/page/viewer_scene.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The file taken apart again by the words of its format alone.
struct ReadScene {
  explicit ReadScene(const std::string& file) {
    EXPECT_EQ(file.substr(0, 8), "STURMVS1");
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + 8, sizeof length);
    EXPECT_EQ(length % 4, 0u);
    header = Json::parse(file.substr(12, length));
    data = file.substr(12 + length);
  }

  template <class Number>
  std::vector<Number> numbers(const Json& place) const {
    std::vector<Number> result(place["components"].get<std::size_t>() * place["count"].get<std::size_t>());
    EXPECT_LE(place["at"].get<std::size_t>() + result.size() * sizeof(Number), data.size());
    EXPECT_EQ(place["at"].get<std::size_t>() % 4, 0u);
    std::memcpy(result.data(), data.data() + place["at"].get<std::size_t>(), result.size() * sizeof(Number));
    return result;
  }

  Json header;
  std::string data;
};

Mesh triangle(float depth) {
  return {.name = "triangle",
          .positions = {{0, 0, -depth}, {1, 0, -depth}, {0, 1, -depth}},
          .triangles = {{0, 1, 2}},
          .texture_coordinates = {}};
}

Material material_of(const char* name, const SurfaceModel& surface = Diffuse{}) {
  Material material;
  material.name = name;
  material.surface = surface;
  return material;
}

SceneDescription grey_triangle() {
  SceneDescription scene;
  scene.materials.push_back(material_of("grey"));
  scene.materials[0].albedo = {0.1f, 0.5f, 0.5f};
  scene.meshes.push_back(triangle(2.0f));
  return scene;
}

ReadScene written(const SceneDescription& scene) {
  return ReadScene(viewer_scene(scene, Scene(scene)));
}

TEST(ViewerScene, HasTheTrianglesOfItsMeshes) {
  const ReadScene scene = written(grey_triangle());
  EXPECT_EQ(scene.header["format"], "sturm.viewer_scene/1");
  EXPECT_THAT(scene.numbers<float>(scene.header["positions"]), ElementsAre(0, 0, -2, 1, 0, -2, 0, 1, -2));
  EXPECT_THAT(scene.numbers<std::uint32_t>(scene.header["triangles"]), ElementsAre(0, 1, 2));
  for (const char* key : {"normals", "texture_coordinates", "emission_coordinates", "colours", "environment"})
    EXPECT_TRUE(scene.header[key].is_null()) << key;
  EXPECT_EQ(scene.header["materials"][0]["type"], "diffuse");
  EXPECT_EQ(scene.header["materials"][0]["albedo"][0].get<float>(), 0.1f);  // to the last bit
  EXPECT_EQ(scene.header["bounds_m"]["lower"], Json({0.0, 0.0, -2.0}));
  EXPECT_EQ(scene.header["offset_unit_m"], 1.0);
}

TEST(ViewerScene, PutsInstancesInTheirPlacesAndKeepsMirroredOnesFacingTheirWay) {
  SceneDescription description = grey_triangle();
  description.prototypes.push_back(triangle(0.0f));
  description.prototypes[0].normals.assign(3, {0.6f, 0.0f, 0.8f});
  Eigen::Matrix<float, 3, 4> moved = Eigen::Matrix<float, 3, 4>::Identity();
  moved(0, 0) = -2.0f;
  moved.col(3) << 5.0f, 0.0f, -3.0f;
  description.instances.push_back({0, moved});
  const ReadScene scene = written(description);
  const auto positions = scene.numbers<float>(scene.header["positions"]);
  EXPECT_THAT(std::vector<float>(positions.begin() + 9, positions.end()), ElementsAre(5, 0, -3, 3, 0, -3, 5, 1, -3));
  EXPECT_THAT(scene.numbers<std::uint32_t>(scene.header["triangles"]), ElementsAre(0, 1, 2, 3, 5, 4));
  const auto normals = scene.numbers<float>(scene.header["normals"]);
  for (int k = 0; k < 9; ++k) EXPECT_EQ(normals[static_cast<std::size_t>(k)], 0.0f);  // the flat mesh
  // Across the plane that the instance stretches to the double: (0.6 / -2, 0, 0.8) made a unit vector.
  EXPECT_NEAR(normals[9], -0.3 / std::hypot(0.3, 0.8), 1e-6);
  EXPECT_NEAR(normals[11], 0.8 / std::hypot(0.3, 0.8), 1e-6);
  EXPECT_EQ(scene.header["meshes"][1]["first_triangle"], 1);
}

TEST(ViewerScene, PicturesLoseNothing) {
  SceneDescription description = grey_triangle();
  auto few = std::make_shared<Image>(4, 2, 3), many = std::make_shared<Image>(300, 300, 1);
  for (std::size_t k = 0; k < few->pixels.size(); ++k) few->pixels[k] = static_cast<float>(k % 7) / 7.0f;
  for (std::size_t k = 0; k < many->pixels.size(); ++k) many->pixels[k] = std::sqrt(static_cast<float>(k));
  auto some = std::make_shared<Image>(300, 1, 3);
  for (std::size_t k = 0; k < some->pixels.size(); ++k) some->pixels[k] = 1.0f / (1.0f + static_cast<float>(k));
  description.meshes[0].texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  Material& material = description.materials[0];
  material.albedo_texture = few;
  material.albedo_mapping.wrap_u = TextureWrap::Mirror;
  material.emission = {1, 1, 1};
  material.emission_texture = few;
  material.opacity.mode = Opacity::Mode::mask;
  material.opacity.texture = many;
  description.environment = Environment{.map = some};
  const ReadScene scene = written(description);
  const Json& textures = scene.header["textures"];
  ASSERT_EQ(textures.size(), 3u);  // one of them is used twice
  const Json& map = scene.header["materials"][0]["albedo_map"];
  EXPECT_EQ(map["wrap"], Json({"mirror", "clamp"}));
  EXPECT_EQ(map["matrix"], Json({1.0, 0.0, 0.0, 0.0, 1.0, 0.0}));
  EXPECT_EQ(map["texture"], scene.header["materials"][0]["emission_map"]["texture"]);
  const auto texels = [&](const Json& number, auto index) {
    const Json& texture = textures[number.get<std::size_t>()];
    const auto table = scene.numbers<float>(texture["table"]);
    std::vector<float> values;
    for (const auto entry : scene.numbers<decltype(index)>(texture["texels"])) values.push_back(table.at(entry));
    return values;
  };
  EXPECT_EQ(texels(map["texture"], std::uint8_t{}), few->pixels);
  EXPECT_EQ(texels(scene.header["environment"]["texture"], std::uint16_t{}), some->pixels);
  const Json& plain = textures[scene.header["materials"][0]["opacity"]["map"]["texture"].get<std::size_t>()];
  EXPECT_TRUE(plain["table"].is_null());
  EXPECT_EQ(scene.numbers<float>(plain["texels"]), many->pixels);
}

TEST(ViewerScene, NamesWhatThePageDrawsOtherwise) {
  SceneDescription description = grey_triangle();
  description.materials.push_back(material_of("shell", SeedMetal{0.5f}));
  description.materials.push_back(material_of("frost", Dielectric{1.5f, 0.3f}));
  description.materials.push_back(material_of("leaf"));
  description.materials.back().opacity.mode = Opacity::Mode::blend;
  description.materials.push_back(material_of("unused", SeedDielectric{}));
  EXPECT_THAT(undrawn(description, {}), ElementsAre());
  for (int material = 1; material <= 3; ++material) description.spheres.push_back({{0, 0, -4}, 0.5f, material});
  RenderSpec spec;
  spec.eye.eye.stiles_crawford_per_m2 = 0.05e6;
  EXPECT_THAT(undrawn(description, spec), ElementsAre(HasSubstr("\"shell\""), HasSubstr("rough glass"),
                                                      HasSubstr("drawn opaque"), HasSubstr("Stiles")));
  EXPECT_EQ(written(description).header["materials"][1]["alpha"], 0.5);
}

}  // namespace
}  // namespace sturm
