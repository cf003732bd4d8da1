// glTF's metallic-roughness materials and pictures inside of a GLB.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/files/error.h"
#include "io/images/png_output.h"
#include "pathtrace/materials/fresnel.h"
#include "pathtrace/scene/gltf_surface.h"
#include "pathtrace/scene/scene_import.h"

namespace sturm {
namespace {

using Eigen::Vector3f;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::string little_endian(std::uint32_t word) {
  std::string bytes;
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> 8 * k & 0xFF);
  return bytes;
}

std::string glb(std::string json, std::string binary) {
  while (json.size() % 4) json += ' ';
  while (binary.size() % 4) binary += '\0';
  const auto size = static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size());
  return "glTF" + little_endian(2) + little_endian(size) + little_endian(static_cast<std::uint32_t>(json.size())) +
         "JSON" + json + little_endian(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
}

std::string float_bytes(std::initializer_list<float> values) {
  std::string bytes;
  for (const float value : values) {
    std::uint32_t word;
    std::memcpy(&word, &value, 4);
    bytes += little_endian(word);
  }
  return bytes;
}

/// A 2 × 1 PNG of two colours; display values.
std::string png(const Vector3f& left, const Vector3f& right) {
  Image image(2, 1, 3);
  for (int c = 0; c < 3; ++c) {
    image.at(0, 0)[c] = left[c];
    image.at(1, 0)[c] = right[c];
  }
  const std::vector<unsigned char> bytes = encode_png(image);
  return {bytes.begin(), bytes.end()};
}

class GltfMaterial : public ::testing::Test {
 protected:
  GltfMaterial() : folder_(fs::temp_directory_path() / ("sturm_gltf_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~GltfMaterial() override { fs::remove_all(folder_); }

  /// A triangle with that material; `picture` is image and texture 0.
  fs::path write(const std::string& material, const std::string& picture = "",
                 std::size_t stated_picture_view = 2) const {
    const std::string positions = float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}),
                      coordinates = float_bytes({0, 0, 1, 0, 0, 1});
    std::string json = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
      "meshes": [{"name": "leaf", "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                    {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
      "materials": [)" +
                       material + "],";
    if (!picture.empty())
      json += R"("textures": [{"source": 0}], "images": [{"mimeType": "image/png", "bufferView": )" +
              std::to_string(stated_picture_view) + "}],";
    json += R"("bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24})";
    if (!picture.empty())
      json += R"(, {"buffer": 0, "byteOffset": 60, "byteLength": )" + std::to_string(picture.size()) + "}";
    json += R"(], "buffers": [{"byteLength": )" + std::to_string(60 + picture.size()) + "}]}";
    const fs::path file = folder_ / "leaf.glb";
    std::ofstream(file, std::ios::binary) << glb(json, positions + coordinates + picture);
    return file;
  }

  static SceneDescription load(const fs::path& file) {
    SceneSpec spec;
    spec.models.push_back({.file = file});
    return build_scene(spec);
  }

  /// Material of the only mesh.
  static Material material_of(const SceneDescription& scene) {
    return scene.materials.at(static_cast<std::size_t>(scene.meshes.at(0).material));
  }

  static std::string error_of(const fs::path& file) {
    try {
      load(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }

  fs::path folder_;
};

TEST_F(GltfMaterial, AMetalReflectsItsBaseColourStraightOn) {
  const GltfSurface gold = gltf_surface({.metallic = 1.0f, .roughness = 0.4f, .base_colour = {0.9f, 0.64f, 0.25f}});
  const auto* metal = std::get_if<Conductor>(&gold.surface);
  ASSERT_TRUE(metal);
  EXPECT_EQ(metal->roughness, 0.4f);  // GGX α = roughness² in both
  EXPECT_EQ(metal->eta, Vector3f::Ones());
  EXPECT_NEAR(metal->kappa.y(), 2.6667f, 1e-4f);  // 2 √(0.64/0.36) = 8/3
  EXPECT_LT((fresnel_conductor(1.0f, metal->eta, metal->kappa) - Vector3f(0.9f, 0.64f, 0.25f)).norm(),
            1e-5f);  // rounding of float
  EXPECT_EQ(gold.left_out, "");
}

TEST_F(GltfMaterial, KindsByMetallicAndRoughness) {
  EXPECT_TRUE(std::holds_alternative<Diffuse>(gltf_surface({.metallic = 0.0f, .roughness = 1.0f}).surface));
  const GltfSurface coat = gltf_surface({.metallic = 0.0f, .roughness = 0.3f, .index = 1.33f});
  ASSERT_TRUE(std::holds_alternative<Plastic>(coat.surface));
  EXPECT_EQ(std::get<Plastic>(coat.surface).roughness(), 0.3f);
  EXPECT_EQ(std::get<Plastic>(coat.surface).index(), 1.33f);
  EXPECT_EQ(std::get<Plastic>(gltf_surface({.metallic = 0.0f, .roughness = 0.005f}).surface).roughness(), 0.0f);
  const GltfSurface half = gltf_surface({.metallic = 0.3f, .roughness = 0.3f});
  EXPECT_TRUE(std::holds_alternative<Plastic>(half.surface));
  EXPECT_THAT(half.left_out, HasSubstr("mixture"));
  const GltfSurface white = gltf_surface({});  // the model's defaults: a rough metal that reflects (nearly) everything
  ASSERT_TRUE(std::holds_alternative<Conductor>(white.surface));
  EXPECT_TRUE(std::get<Conductor>(white.surface).kappa.allFinite());
}

TEST_F(GltfMaterial, FactorsComeFromTheFile) {
  const SceneDescription scene = load(write(
      R"({"name": "steel", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 1, "roughnessFactor": 0.25}})"));
  const Material steel = material_of(scene);
  ASSERT_TRUE(std::holds_alternative<Conductor>(steel.surface));
  EXPECT_EQ(std::get<Conductor>(steel.surface).roughness, 0.25f);
  EXPECT_NEAR(std::get<Conductor>(steel.surface).kappa.x(), 2.0f, 1e-6f);  // R = ½
  EXPECT_TRUE(scene.notes.empty());
  EXPECT_TRUE(std::holds_alternative<Diffuse>(
      material_of(load(write(R"({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}})"))).surface));
}

TEST_F(GltfMaterial, TheBaseColoursPictureMayStandInTheFile) {
  const Material material = material_of(load(write(
      R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 0.5}})",
      png({1, 0, 0}, {0, 0, 1}))));
  ASSERT_TRUE(material.albedo_texture);
  EXPECT_EQ(material.albedo_texture->width, 2);
  EXPECT_THAT(std::vector<float>(material.albedo_texture->at(0, 0), material.albedo_texture->at(0, 0) + 3),
              ElementsAre(1, 0, 0));
  EXPECT_THAT(std::vector<float>(material.albedo_texture->at(1, 0), material.albedo_texture->at(1, 0) + 3),
              ElementsAre(0, 0, 1));
  EXPECT_TRUE(std::holds_alternative<Plastic>(material.surface));
}

TEST_F(GltfMaterial, AMetallicRoughnessTextureCountsWithItsMean) {
  // Roughness in green: mean of 0.2 and 0.6 as stored, no sRGB curve; metallic in blue: 1. Red is left alone.
  const SceneDescription scene =
      load(write(R"({"name": "worn", "pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}}})",
                 png({0, 0.2f, 1}, {1, 0.6f, 1})));
  const Material worn = material_of(scene);
  ASSERT_TRUE(std::holds_alternative<Conductor>(worn.surface));
  EXPECT_NEAR(std::get<Conductor>(worn.surface).roughness, 0.4f, 0.5f / 255.0f);  // 8-bit rounding
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_THAT(scene.notes[0], HasSubstr("mean of its metallic-roughness texture"));
}

TEST_F(GltfMaterial, AMetalsTextureTintsItPointByPoint) {
  const SceneDescription scene =
      load(write(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "roughnessFactor": 0.5}})",
                 png({1, 1, 1}, {0, 0, 0})));
  const Material metal = material_of(scene);
  ASSERT_TRUE(metal.albedo_texture);
  EXPECT_EQ(*metal.albedo_texture->at(0, 0), 1.0f);
  EXPECT_EQ(*metal.albedo_texture->at(1, 0), 0.0f);
  ASSERT_TRUE(std::holds_alternative<TintedMetal>(metal.surface));
  EXPECT_EQ(std::get<TintedMetal>(metal.surface).roughness, 0.5f);
  EXPECT_TRUE(scene.notes.empty());
}

TEST_F(GltfMaterial, ATintedMetalReflectsAsTheMetalOfThatColour) {
  const Vector3f out = Vector3f(0.3f, 0.1f, 0.9f).normalized(), in = Vector3f(-0.2f, 0.2f, 0.8f).normalized(),
                 gold(0.9f, 0.64f, 0.25f);
  Conductor metal;
  metal.roughness = 0.4f;
  metal.eta = Vector3f::Ones();
  metal.kappa = {6.0f, 2.6666667f, 1.1547005f};  // 2 √(R/(1 − R)): 2 √9, 2 √(16/9), 2 √(1/3)
  const BsdfValue right = metal.evaluate(out, in, Vector3f::Ones()), seen = TintedMetal{0.4f}.evaluate(out, in, gold);
  EXPECT_LT((right.value - seen.value).norm(), 1e-5f * right.value.norm());  // rounding of float
  EXPECT_EQ(right.pdf, seen.pdf);
}

TEST_F(GltfMaterial, WrongFilesAreRefused) {
  const std::string textured =
      R"({"name": "m", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}})";
  EXPECT_THAT(error_of(write(textured, "this is no picture at all, but as long as one")),
              HasSubstr("neither a PNG nor a JPEG"));
  std::string broken = png({1, 0, 0}, {0, 0, 1});
  broken.resize(40);
  EXPECT_THAT(error_of(write(textured, broken)), HasSubstr("material \"m\""));
  EXPECT_THAT(error_of(write(textured, png({1, 0, 0}, {0, 0, 1}), 7)), HasSubstr("/images/0/bufferView"));
  EXPECT_THAT(error_of(write(R"({"name": "m", "pbrMetallicRoughness": {"roughnessFactor": 1.5}})")),
              HasSubstr("a factor from 0 to 1"));
}

}  // namespace
}  // namespace sturm
