#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/json.h"
#include "pathtrace/scene/assimp_import.h"
#include "pathtrace/scene/scene_import.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path source_dir = STURM_SOURCE_DIR;

SceneDescription import_linear(const fs::path& file, double scale = 1.0) {
  return import_model({.file = file,
                       .scale = scale,
                       .texture_encoding = TextureEncoding::Linear,
                       .texture_filter = TextureFilter::Nearest});
}

/// A folder of small files that goes away with the test.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() /
              ("sturm_import_" + std::to_string(::getpid()) + "_" + std::to_string(++count_))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  static inline int count_ = 0;
  fs::path path_;
};

const Mesh& mesh_named(const SceneDescription& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& m) { return m.name == name; });
  if (found == scene.meshes.end()) throw std::out_of_range("no mesh " + name);
  return *found;
}

Eigen::Vector3d corner(const Mesh& mesh, std::size_t triangle, int k) {
  return mesh.positions[mesh.triangles[triangle][k]].cast<double>();
}

/// Half the cross product: area and facing of a triangle.
Eigen::Vector3d area_vector(const Mesh& mesh, std::size_t triangle) {
  const Eigen::Vector3d a = corner(mesh, triangle, 0), b = corner(mesh, triangle, 1), c = corner(mesh, triangle, 2);
  return 0.5 * (b - a).cross(c - a);
}

Eigen::Vector3d area_vector(const Mesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += area_vector(mesh, t);
  return sum;
}

double volume_below_outward_faces(const Mesh& mesh) {
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) volume += corner(mesh, t, 0).dot(area_vector(mesh, t)) / 3.0;
  return volume;
}

void expect_error(const fs::path& file, const std::vector<std::string>& parts) {
  try {
    import_linear(file);
    FAIL() << "no error for " << file;
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr(file.string()));
    for (const auto& part : parts) EXPECT_THAT(e.what(), HasSubstr(part));
  }
}

TEST(SceneImport, PlainRoomEqualsItsAuthoritativeDescription) {
  const SceneDescription scene = import_linear(source_dir / "tests/reference/scene_plain/scene.obj");
  const Json truth = load_json((source_dir / "tests/reference/scene_plain/scene.json").string());
  ASSERT_EQ(scene.meshes.size(), truth["meshes"].size());
  std::size_t triangles = 0;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const Json& expected = truth["meshes"][m];
    const Mesh& mesh = scene.meshes[m];
    EXPECT_EQ(mesh.name, expected["name"]);
    const Material& material = scene.materials[mesh.material];
    EXPECT_EQ(material.name, expected["material"]);
    const Json& colours = truth["materials"][material.name];
    for (int c = 0; c < 3; ++c) {
      EXPECT_FLOAT_EQ(material.albedo[c], colours["albedo"][c]);
      EXPECT_FLOAT_EQ(material.emission[c], colours.contains("emission") ? colours["emission"][c].get<float>() : 0.0f);
    }
    ASSERT_EQ(mesh.triangles.size(), expected["faces"].size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)  // 2 ulp: Assimp parses numbers on its own
          EXPECT_NEAR(corner(mesh, t, k)[axis],
                      expected["positions"][expected["faces"][t][k].get<int>()][axis].get<double>(), 1.2e-7);
    triangles += mesh.triangles.size();
  }
  EXPECT_EQ(triangles, 38u);
}

TEST(SceneImport, TexturesThatNothingUsesAreNotLoaded) {
  Folder folder;
  folder.write("a.mtl", "newmtl plain\nKd 1 0 0\nnewmtl chart\nKd 1 1 1\nmap_Kd gone.png\n");
  const SceneDescription scene =
      import_linear(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl plain\nf 1 2 3\n"));
  EXPECT_EQ(scene.materials[scene.meshes[0].material].name, "plain");
}

TEST(SceneImport, ScaleIsMetresPerUnit) {
  const fs::path file = source_dir / "tests/reference/scene_plain/scene.obj";
  EXPECT_NEAR(mesh_named(import_linear(file, 1e-3), "floor").positions[0].x(), 0.5528e-3, 1e-10);
}

TEST(SceneImport, TexturesAreReadDecodedAndShared) {
  Folder folder;
  fs::copy(source_dir / "tests/reference/scene_plain/chart.png", folder.path());
  const fs::path obj =
      folder.write("a.obj",
                   "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.25 0\nvt 1 0\nvt 1 1\nvt 0 0.75\n"
                   "o one\nusemtl chart\nf 1/1 2/2 3/3\no two\nusemtl tinted\nf 1/1 3/3 4/4\n");
  folder.write("a.mtl", "newmtl chart\nKd 1 1 1\nmap_Kd chart.png\nnewmtl tinted\nKd 0.5 0.25 1\nmap_Kd chart.png\n");
  const SceneDescription linear = import_linear(obj);
  const SceneDescription srgb = import_model({.file = obj});
  const Mesh& two = mesh_named(linear, "two");
  const Material& tinted = linear.materials[two.material];
  ASSERT_TRUE(tinted.albedo_texture);
  EXPECT_EQ(tinted.albedo_texture->channels, 3);
  EXPECT_EQ(tinted.albedo_texture->width, 256);
  EXPECT_EQ(tinted.albedo_texture, linear.materials[mesh_named(linear, "one").material].albedo_texture);
  EXPECT_EQ(tinted.albedo, Eigen::Vector3f(0.5f, 0.25f, 1.0f));
  EXPECT_TRUE(tinted.nearest_filter);
  ASSERT_EQ(two.texture_coordinates.size(), two.positions.size());
  const auto index = two.triangles[0];
  EXPECT_EQ(two.texture_coordinates[index[0]], Eigen::Vector2f(0.25f, 0.0f));  // v upwards, as in the file
  EXPECT_EQ(two.texture_coordinates[index[2]], Eigen::Vector2f(0.0f, 0.75f));

  const Material& decoded = srgb.materials[mesh_named(srgb, "two").material];
  EXPECT_FALSE(decoded.nearest_filter);
  bool between = false;
  for (std::size_t i = 0; i < tinted.albedo_texture->pixels.size(); ++i) {
    const float stored = tinted.albedo_texture->pixels[i], light = decoded.albedo_texture->pixels[i];
    if (stored <= 0.04f || stored >= 0.999f) continue;
    between = true;
    EXPECT_NEAR(light, std::pow((stored + 0.055) / 1.055, 2.4), 1e-6);
  }
  EXPECT_TRUE(between) << "the chart should have grey values";
}

TEST(SceneImport, QuadsKeepTheirWindingAndNearVerticesStayApart) {
  Folder folder;
  const fs::path obj =
      folder.write("q.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.000001 0 0\nf 1 2 3 4\nf 5 4 3\n");
  const SceneDescription scene = import_linear(obj);
  ASSERT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.meshes[0].triangles.size(), 3u);
  EXPECT_GT(area_vector(scene.meshes[0], 0).z(), 0.0);
  EXPECT_GT(area_vector(scene.meshes[0], 1).z(), 0.0);
  EXPECT_LT(area_vector(scene.meshes[0], 2).z(), 0.0);
  EXPECT_EQ(corner(scene.meshes[0], 2, 0).x(), static_cast<double>(1e-6f));
}

// A triangle seen from +z under a node that mirrors x and moves by 5 along y; emission of strength 3.
constexpr const char* mirrored_gltf = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"translation": [0, 5, 0], "children": [1]}, {"mesh": 0, "scale": [-2, 1, 1]}],
  "materials": [{"name": "lamp", "pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0.75, 1]}, "emissiveFactor": [1, 0.5, 0]}],
  "meshes": [{"name": "triangle", "primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

TEST(SceneImport, GltfNodesAreAppliedAndMirrorsKeepSurfacesFacingTheirWay) {
  Folder folder;
  const SceneDescription scene = import_linear(folder.write("m.gltf", mirrored_gltf));
  ASSERT_EQ(scene.meshes.size(), 1u);
  const Eigen::Vector3d area = area_vector(scene.meshes[0]);
  EXPECT_NEAR(area.z(), 1.0, 1e-6);  // ½ · 2, still facing +z
  double least_x = 0.0, least_y = 9.0;
  for (const auto& p : scene.meshes[0].positions)
    least_x = std::min<double>(least_x, p.x()), least_y = std::min<double>(least_y, p.y());
  EXPECT_FLOAT_EQ(least_x, -2.0);
  EXPECT_FLOAT_EQ(least_y, 5.0);
  const Material& material = scene.materials[scene.meshes[0].material];
  EXPECT_EQ(material.albedo, Eigen::Vector3f(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(material.emission, Eigen::Vector3f(1.0f, 0.5f, 0.0f));
}

TEST(SceneImport, WrongModelsAreNamed) {
  Folder folder;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_error(folder.path() / "absent.obj", {"exists"});
  expect_error(folder.write("empty.obj", ""), {});
  expect_error(folder.write("points.obj", triangle), {});
  expect_error(folder.write("noise.gltf", "this is no model"), {"noise.gltf:1", "JSON"});
  expect_error(folder.write("noise.dae", "this is no model"), {"Assimp"});
  expect_error(folder.write("other.xyzzy", "this is no model"), {"Assimp"});
  expect_error(folder.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), {"not finite"});
  expect_error(folder.write("no_library.obj", "mtllib gone.mtl\n" + triangle + "usemtl red\nf 1 2 3\n"),
               {"no_library.obj:1", "gone.mtl"});
  folder.write("lib.mtl", "newmtl red\nKd 1 0 0\nnewmtl textured\nKd 1 1 1\nmap_Kd gone.png\n");
  expect_error(folder.write("no_texture.obj", "mtllib lib.mtl\n" + triangle + "usemtl textured\nf 1 2 3\n"),
               {"textured", "gone.png"});
  expect_error(folder.write("no_material.obj", "mtllib lib.mtl\n" + triangle + "usemtl blue\nf 1 2 3\n"),
               {"no_material.obj:5", "blue"});
  folder.write("bright.mtl", "newmtl white\nKd 1 1.5 1\n");
  expect_error(folder.write("bright.obj", "mtllib bright.mtl\n" + triangle + "usemtl white\nf 1 2 3\n"),
               {"white", "1.5"});
}

TEST(SceneImport, InPlaceThingsComeBeforeModels) {
  SceneSpec spec;
  spec.materials = {{"a", {0.1, 0.2, 0.3}, {0.0, 0.0, 0.0}}, {"b", {0.0, 0.0, 0.0}, {4.0, 5.0, 6.0}}};
  spec.meshes = {{"m", 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}};
  spec.spheres = {{{1, 2, 3}, 0.5, 0}};
  spec.lights = {{{7, 8, 9}, {1, 1, 2}}};
  spec.models = {
      {source_dir / "tests/reference/scene_plain/scene.obj", 1.0, TextureEncoding::Linear, TextureFilter::Nearest}};
  const SceneDescription scene = build_scene(spec);
  ASSERT_EQ(scene.meshes.size(), 12u);
  EXPECT_EQ(scene.meshes[0].material, 1);
  EXPECT_EQ(scene.materials[1].emission, Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(scene.materials[mesh_named(scene, "left_red").material].name,
            "red");  // numbers shifted past those in place
  ASSERT_EQ(scene.spheres.size(), 1u);
  EXPECT_EQ(scene.spheres[0].center, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(scene.spheres[0].radius, 0.5f);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].intensity, Eigen::Vector3f(1, 1, 2));
}

SceneDescription cornell_box() {
  return build_scene(read_scene("configs/scenes/cornell_box.json", {(source_dir / "here.json").string(), "/scene"}));
}

TEST(CornellBox, HasTheMeasuredAreasAndFacesTheRoom) {
  const SceneDescription box = cornell_box();
  // Trapezium (552.8 + 549.6)/2 · 559.2 mm², facing up; the light 130 · 105 mm², facing down. float vertices: 1e-7
  // relative.
  EXPECT_NEAR(area_vector(mesh_named(box, "floor")).y(), 0.5512 * 0.5592, 1e-7);
  EXPECT_NEAR(area_vector(mesh_named(box, "light")).y(), -0.130 * 0.105, 1e-8);
  double ceiling = 0.0;
  for (const char* part : {"front", "rear", "left", "right"}) {
    const double down = -area_vector(mesh_named(box, std::string("ceiling_") + part)).y();
    EXPECT_GT(down, 0.0) << part;
    ceiling += down;
  }
  EXPECT_NEAR(ceiling, 0.556 * 0.5592 - 0.130 * 0.105, 1e-7);
  EXPECT_LT(area_vector(mesh_named(box, "back")).z(), 0.0);
  EXPECT_GT(area_vector(mesh_named(box, "right_green")).x(), 0.0);
  EXPECT_LT(area_vector(mesh_named(box, "left_red")).x(), 0.0);
}

TEST(CornellBox, BlocksFaceOutwardsAndStandOnTheFloor) {
  const SceneDescription box = cornell_box();
  for (const auto& [name, height] : {std::pair{"short_block", 0.165}, {"tall_block", 0.330}}) {
    const Mesh& mesh = mesh_named(box, name);
    ASSERT_EQ(mesh.triangles.size(), 10u);
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const auto& p : mesh.positions) centre += p.cast<double>() / static_cast<double>(mesh.positions.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      EXPECT_GT(area_vector(mesh, t).dot(corner(mesh, t, 0) - centre), 0.0) << name << ' ' << t;
    EXPECT_NEAR(centre.y(), height / 2, 1e-7);
    // The open bottom lies at y = 0 and adds nothing: the divergence theorem gives height · area of the top.
    const double top = area_vector(mesh, 0).y() + area_vector(mesh, 1).y();
    EXPECT_NEAR(volume_below_outward_faces(mesh), height * top, 1e-8);
    EXPECT_NEAR(top, 0.165 * 0.165, 0.0015);  // 158 to 167 mm sides as measured
  }
}

TEST(CornellBox, RedIsOnTheImagesLeft) {
  const SceneDescription box = cornell_box();
  const Eigen::Vector3d look(0, 0, 1), up(0, 1, 0), image_right = look.cross(up), camera(0.278, 0.273, -0.8);
  const auto column = [&](const char* name) { return image_right.dot(corner(mesh_named(box, name), 0, 0) - camera); };
  EXPECT_LT(column("left_red"), -0.2);
  EXPECT_GT(column("right_green"), 0.2);
  const auto albedo = [&](const char* name) { return box.materials[mesh_named(box, name).material].albedo; };
  EXPECT_GT(albedo("left_red").x(), 5.0f * albedo("left_red").y());
  EXPECT_GT(albedo("right_green").y(), 3.0f * albedo("right_green").x());
}

TEST(CornellBox, ColoursAreThoseOfTheMeasuredSpectraUnderTheMeasuredLight) {
  const SceneDescription box = cornell_box();
  const Eigen::Vector3f white = box.materials[mesh_named(box, "floor").material].albedo;
  // The white paint measures 0.70 to 0.78 from 430 nm on: so must every channel, which are weighted means of it but for
  // Rec. 709's small negative parts.
  EXPECT_GT(white.minCoeff(), 0.70f);
  EXPECT_LT(white.maxCoeff(), 0.78f);
  const Material& light = box.materials[mesh_named(box, "light").material];
  EXPECT_EQ(light.albedo, Eigen::Vector3f::Constant(0.78f));
  // Luminance relative to a spectrum of 1: the lamp's value where the eye's sensitivity is centred, 8 + 0.076 (λ − 500)
  // at 560 ± 5 nm.
  EXPECT_NEAR(light.emission.dot(Eigen::Vector3f(0.2126f, 0.7152f, 0.0722f)), 12.56f, 0.4f);
}

}  // namespace
}  // namespace sturm
