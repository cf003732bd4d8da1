// Normals, instances, overrides and notes of model files, and files that lie about themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/files/error.h"
#include "pathtrace/scene/embree_rays.h"
#include "pathtrace/scene/scene.h"
#include "pathtrace/scene/scene_import.h"

namespace sturm {
namespace {

using Eigen::Vector3f;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// A folder that goes away with the test.
class ModelImport : public ::testing::Test {
 protected:
  ModelImport() : folder_(fs::temp_directory_path() / ("sturm_model_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~ModelImport() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  static SceneDescription load(const fs::path& file, const std::vector<MaterialOverride>& overrides = {}) {
    SceneSpec spec;
    spec.models.push_back({.file = file, .overrides = overrides});
    return build_scene(spec);
  }

  static std::string error_of(const fs::path& file, const std::vector<MaterialOverride>& overrides = {}) {
    try {
      const Scene scene(load(file, overrides));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }

  fs::path folder_;
};

/// The triangle (0,0,0) (1,0,0) (0,1,0) as glTF; `nodes`, `scene_nodes` and what else differs.
std::string gltf(const std::string& nodes, const std::string& roots, const std::string& count = "3",
                 const std::string& bytes = "36") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": )" + roots + R"(}], "nodes": )" + nodes +
         R"(, "meshes": [{"name": "leaf", "primitives": [{"attributes": {"POSITION": 0}}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": )" +
         count +
         R"(, "type": "VEC3"}], "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": )" +
         bytes +
         R"(, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

const std::string two_leaves = R"([{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0], "scale": [-2, 1, 1]}])";

MaterialOverride lamp() {
  MaterialSpec material;
  material.emission = {3.0, 2.0, 1.0};
  return {"leaf", material};
}

/// What a ray along −z through (x, y, 1) meets.
std::optional<SurfacePoint> seen_at(const Scene& scene, float x, float y) {
  const Vector3f origin(x, y, 1.0f), direction(0.0f, 0.0f, -1.0f);
  RTCRayHit ray = ray_from(origin, direction);
  if (!intersect(scene.embree(), ray)) return std::nullopt;
  return scene.surface_point(ray.hit, origin, direction, ray.ray.tfar);
}

TEST_F(ModelImport, ARepeatedMeshIsOnePrototype) {
  const SceneDescription description = load(write("leaves.gltf", gltf(two_leaves, "[0, 1]")));
  EXPECT_TRUE(description.meshes.empty());
  ASSERT_EQ(description.prototypes.size(), 1u);
  ASSERT_EQ(description.instances.size(), 2u);
  const Scene scene(description);
  EXPECT_EQ(scene.triangle_count(), 1u);
  // The second is mirrored, twice as wide and stands at x = 3 … 5; both face +z.
  for (const auto& [x, y] : {std::pair{0.2f, 0.2f}, {4.6f, 0.2f}, {3.2f, 0.05f}}) {
    const auto point = seen_at(scene, x, y);
    ASSERT_TRUE(point) << x;
    EXPECT_NEAR((point->normal - Vector3f(0, 0, 1)).norm(), 0.0f, 1e-6f) << x;
    EXPECT_NEAR(point->position.x(), x, 1e-6f);
  }
  EXPECT_FALSE(seen_at(scene, 5.2f, 0.2f));
  EXPECT_FALSE(seen_at(scene, 2.0f, 0.2f));
  EXPECT_FLOAT_EQ(scene.lower().x(), 0.0f);
  EXPECT_FLOAT_EQ(scene.upper().x(), 5.0f);
}

TEST_F(ModelImport, InstancesThatEmitBecomeLightsInPlace) {
  const SceneDescription description = load(write("leaves.gltf", gltf(two_leaves, "[0, 1]")), {lamp()});
  EXPECT_TRUE(description.instances.empty());
  ASSERT_EQ(description.meshes.size(), 2u);
  const Scene scene(description);
  EXPECT_EQ(scene.lights().size(), 2);
  const auto point = seen_at(scene, 4.6f, 0.2f);
  ASSERT_TRUE(point);
  EXPECT_GT(point->normal.z(), 0.99f);
  EXPECT_EQ(point->material->emission, Vector3f(3, 2, 1));
}

TEST_F(ModelImport, AModelIsTurnedThenPutInItsPlace) {
  // A quarter turn to the left, seen from above, takes +x to −z; the mirrored instance at x = 3 … 5 moves along.
  SceneSpec spec;
  spec.models.push_back(
      {.file = write("leaves.gltf", gltf(two_leaves, "[0, 1]")), .turn = 0.5 * M_PI, .position = {10.0, 2.0, -1.0}});
  const Scene scene(build_scene(spec));
  EXPECT_NEAR(scene.lower().z(), -6.0f, 1e-5f);  // rounding of float
  EXPECT_NEAR(scene.upper().z(), -1.0f, 1e-5f);
  EXPECT_NEAR(scene.lower().y(), 2.0f, 1e-6f);
  EXPECT_NEAR(scene.upper().y(), 3.0f, 1e-6f);
  EXPECT_NEAR(scene.lower().x(), 10.0f, 1e-5f);
  const Vector3f origin(12.0f, 2.2f, -1.2f), direction(-1.0f, 0.0f, 0.0f);
  RTCRayHit ray = ray_from(origin, direction);
  ASSERT_TRUE(intersect(scene.embree(), ray));
  EXPECT_GT(scene.surface_point(ray.hit, origin, direction, ray.ray.tfar).normal.x(),
            0.999f);  // the front was towards +z
}

TEST_F(ModelImport, VertexNormalsTurnWithTheirModel) {
  // Normals that lean towards +x beside a face towards +z.
  const fs::path file = write("lean.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\n");
  SceneSpec spec;
  spec.models.push_back({.file = file, .turn = 0.5 * M_PI});
  const SceneDescription description = build_scene(spec);
  ASSERT_EQ(description.meshes.at(0).normals.size(), 3u);
  EXPECT_LT((description.meshes[0].normals[0] - Vector3f(0.8f, 0.0f, -0.6f)).norm(), 1e-6f);
}

TEST_F(ModelImport, OverridesReplaceTheMaterialOfOneMesh) {
  const fs::path file = write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no one\nf 1 2 3\no two\nf 1 3 2\n");
  MaterialSpec gold;
  gold.surface = ConductorSpec{.metal = "gold", .roughness = 0.2};
  const SceneDescription description = load(file, {{"two", gold}});
  for (const Mesh& mesh : description.meshes)
    EXPECT_EQ(std::holds_alternative<Conductor>(description.materials[mesh.material].surface), mesh.name == "two")
        << mesh.name;
  EXPECT_THAT(error_of(file, {{"twp", gold}}), HasSubstr("two"));
}

TEST_F(ModelImport, NormalsAreKeptWhereTheyBend) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const SceneDescription flat = load(write("flat.obj", corners + "vn 0 0 1\nf 1//1 2//1 3//1\n"));
  EXPECT_TRUE(flat.meshes[0].normals.empty());
  EXPECT_EQ(Scene(flat).kind(), Scene::Kind::plain);
  const SceneDescription bent =
      load(write("bent.obj", corners + "vn 0 0 1\nvn 0.6 0 0.8\nvn 0 0.6 0.8\nf 1//1 2//2 3//3\n"));
  ASSERT_EQ(bent.meshes[0].normals.size(), 3u);
  const Scene scene(bent);
  EXPECT_EQ(scene.kind(), Scene::Kind::diffuse);
  const auto point = seen_at(scene, 0.5f, 0.25f);  // barycentric ¼, ½, ¼
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->normal - Vector3f(0, 0, 1)).norm(), 0.0f, 1e-6f);
  EXPECT_NEAR((point->shading_normal - Vector3f(0.3f, 0.15f, 0.85f).normalized()).norm(), 0.0f, 1e-6f);
}

TEST_F(ModelImport, WhatIsLeftOutIsNoted) {
  write("glass.mtl", "newmtl glass\nKd 1 1 1\nd 0.3\n");
  const SceneDescription description =
      load(write("glass.obj", "mtllib glass.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glass\nf 1 2 3\n"));
  ASSERT_EQ(description.notes.size(), 1u);
  EXPECT_THAT(description.notes[0],
              ::testing::AllOf(HasSubstr("glass.obj"), HasSubstr("\"glass\""), HasSubstr("transparency")));
}

TEST_F(ModelImport, FilesThatLieAreNamed) {
  EXPECT_EQ(error_of(write("good.gltf", gltf(R"([{"mesh": 0}])", "[0]"))), "no InputError");
  EXPECT_THAT(error_of(write("cycle.gltf", gltf(R"([{"children": [1]}, {"children": [0], "mesh": 0}])", "[0]"))),
              HasSubstr("its own ancestor"));
  EXPECT_THAT(error_of(write("self.gltf", gltf(R"([{"children": [0], "mesh": 0}])", "[0]"))),
              HasSubstr("its own ancestor"));
  EXPECT_THAT(
      error_of(write("two_parents.gltf", gltf(R"([{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}])", "[0]"))),
      HasSubstr("one parent"));
  EXPECT_THAT(error_of(write("count.gltf", gltf(R"([{"mesh": 0}])", "[0]", "4000000000"))),
              HasSubstr("/accessors/0/count"));
  EXPECT_THAT(error_of(write("count4.gltf", gltf(R"([{"mesh": 0}])", "[0]", "4"))), HasSubstr("/accessors/0/count"));
  EXPECT_THAT(error_of(write("bytes.gltf", gltf(R"([{"mesh": 0}])", "[0]", "3", "4294967295"))),
              HasSubstr("/buffers/0/byteLength"));
  const std::string claim("glTF\x02\0\0\0\xF0\xFF\xFF\xFF\x10\0\0\0JSON{}              ", 36);
  EXPECT_THAT(error_of(write("claim.glb", claim)), HasSubstr("4294967280 bytes"));
  EXPECT_THAT(error_of(write("short.glb", "glTF")), HasSubstr("short.glb"));
  const std::string collada = R"(<COLLADA version="1.4.1"><library_nodes><node id="a"><instance_node url="#b"/></node>
<node id="b"><instance_node url='#a'/></node></library_nodes></COLLADA>)";
  EXPECT_THAT(error_of(write("cycle.dae", collada)), HasSubstr("holds itself"));
  EXPECT_THAT(error_of(write("huge.obj", "v 0 0 0\nv 1e9 0 0\nv 0 1e9 0\nf 1 2 3\n")), HasSubstr("1e6 m"));
}

TEST_F(ModelImport, TrianglesWithoutAreaAreNotSeenAndDoNoHarm) {
  const Scene scene(load(write("degenerate.obj",
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 2\nf 1 2 4\nf 1 2 3\nv 0 0 0.5\nv 1e-12 0 "
                               "0.5\nv 0 1e-12 0.5\nf 5 6 7\n")));
  const auto point = seen_at(scene, 0.25f, 0.25f);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->normal, Vector3f(0, 0, 1));
  const auto on_the_edge = seen_at(scene, 0.0f, 0.0f);
  EXPECT_TRUE(!on_the_edge || on_the_edge->normal.allFinite());
}

}  // namespace
}  // namespace sturm
