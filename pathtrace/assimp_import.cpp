#include "pathtrace/assimp_import.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/error.h"
#include "io/image_formats.h"
#include "io/tone_map.h"
#include "pathtrace/obj_references.h"

namespace sturm {
namespace {

class ModelImport {
 public:
  ModelImport(const std::filesystem::path& file, double scale, TextureEncoding encoding, TextureFilter filter)
      : file_(file), scale_(scale), encoding_(encoding), filter_(filter) {}

  SceneDescription run() {
    if (!std::filesystem::is_regular_file(file_)) fail("", "", "a model file that exists");
    if (!(scale_ > 0.0 && std::isfinite(scale_))) fail("scale", std::to_string(scale_), "a positive number");
    if (lower_case_extension() == ".obj") check_obj_references(file_);
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // No JoinIdenticalVertices: positions stay exactly those of the file, and flat shading needs no shared vertices.
    const aiScene* scene = importer.ReadFile(file_.string(), aiProcess_Triangulate | aiProcess_SortByPType);
    if (!scene || !scene->mRootNode) fail("", importer.GetErrorString(), "a model that Assimp can read");
    // A library may define more than the model uses: textures nobody sees are not loaded.
    std::vector<bool> used(scene->mNumMaterials, false);
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) used.at(scene->mMeshes[i]->mMaterialIndex) = true;
    for (unsigned i = 0; i < scene->mNumMaterials; ++i) add_material(*scene->mMaterials[i], used[i]);
    add_node(*scene, *scene->mRootNode, aiMatrix4x4());
    if (result_.meshes.empty()) fail("", "no triangles", "a model with at least one triangle");
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& value, const std::string& expected) const {
    throw InputError(file_.string(), where, value, expected);
  }

  std::string lower_case_extension() const {
    std::string extension = file_.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
  }

  Eigen::Vector3f checked_colour(const aiColor3D& colour, float largest, const std::string& where, const std::string& expected) const {
    for (const float value : {colour.r, colour.g, colour.b})
      if (!(value >= 0.0f && value <= largest && std::isfinite(value))) fail(where, std::to_string(value), expected);
    return {colour.r, colour.g, colour.b};
  }

  void add_material(const aiMaterial& source, bool used) {
    Material material;
    material.name = source.GetName().C_Str();
    const std::string where = "material \"" + material.name + "\"";
    aiColor3D base(0, 0, 0), emission(0, 0, 0);
    if (source.Get(AI_MATKEY_BASE_COLOR, base) != aiReturn_SUCCESS) source.Get(AI_MATKEY_COLOR_DIFFUSE, base);
    float strength = 1.0f;
    source.Get(AI_MATKEY_COLOR_EMISSIVE, emission);
    source.Get(AI_MATKEY_EMISSIVE_INTENSITY, strength);
    material.albedo = checked_colour(base, 1.0f, where + ", base colour", "reflectances from 0 to 1");
    material.emission =
        checked_colour(emission * strength, std::numeric_limits<float>::max(), where + ", emission", "a finite radiance of at least 0");
    aiString path;
    if (used && (source.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == aiReturn_SUCCESS ||
                 source.GetTexture(aiTextureType_DIFFUSE, 0, &path) == aiReturn_SUCCESS))
      material.albedo_texture = texture(path.C_Str(), where);
    material.nearest_filter = filter_ == TextureFilter::Nearest;
    result_.materials.push_back(std::move(material));
  }

  std::shared_ptr<const Image> texture(std::string name, const std::string& where) {
    if (name.starts_with('*')) fail(where, "an embedded texture", "textures in files of their own");
    std::replace(name.begin(), name.end(), '\\', '/');  // model files from Windows
    std::shared_ptr<const Image>& known = textures_[name];
    if (known) return known;
    const auto path = file_.parent_path() / name;
    if (!std::filesystem::is_regular_file(path)) fail(where, path.string(), "a texture file that exists");
    Image stored = read_image(path);
    if (encoding_ == TextureEncoding::Srgb) stored = srgb_to_linear(stored);
    Image rgb(stored.width, stored.height, 3);
    const bool grey = stored.channels <= 2;
    for (int y = 0; y < rgb.height; ++y)
      for (int x = 0; x < rgb.width; ++x)
        for (int c = 0; c < 3; ++c) rgb.at(x, y)[c] = stored.at(x, y)[grey ? 0 : c];
    return known = std::make_shared<const Image>(std::move(rgb));
  }

  void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& world_from_parent) {
    const aiMatrix4x4 world_from_node = world_from_parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add_mesh(*scene.mMeshes[node.mMeshes[i]], world_from_node);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], world_from_node);
  }

  void add_mesh(const aiMesh& source, const aiMatrix4x4& world_from_node) {
    Mesh mesh;
    mesh.name = source.mName.C_Str();
    mesh.material = static_cast<int>(source.mMaterialIndex);
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = world_from_node * source.mVertices[i];
      const Eigen::Vector3f position = (scale_ * Eigen::Vector3d(p.x, p.y, p.z)).cast<float>();
      if (!position.allFinite()) fail("mesh \"" + mesh.name + "\"", "vertex " + std::to_string(i) + " is not finite", "finite positions");
      mesh.positions.push_back(position);
      if (!source.HasTextureCoords(0)) continue;
      const Eigen::Vector2f uv(source.mTextureCoords[0][i].x, source.mTextureCoords[0][i].y);
      if (!uv.allFinite())
        fail("mesh \"" + mesh.name + "\"", "texture coordinate " + std::to_string(i) + " is not finite", "finite coordinates");
      mesh.texture_coordinates.push_back(uv);
    }
    const bool mirrored = world_from_node.Determinant() < 0.0f;
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
      const aiFace& face = source.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines that share a mesh with triangles
      std::array<std::uint32_t, 3> triangle{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
      if (*std::max_element(triangle.begin(), triangle.end()) >= source.mNumVertices)
        fail("mesh \"" + mesh.name + "\"", "face " + std::to_string(f) + " names a vertex that does not exist", "valid vertex numbers");
      if (mirrored) std::swap(triangle[1], triangle[2]);
      mesh.triangles.push_back(triangle);
    }
    if (!mesh.triangles.empty()) result_.meshes.push_back(std::move(mesh));
  }

  const std::filesystem::path& file_;
  double scale_;
  TextureEncoding encoding_;
  TextureFilter filter_;
  std::map<std::string, std::shared_ptr<const Image>> textures_;
  SceneDescription result_;
};

}  // namespace

SceneDescription import_model(const std::filesystem::path& file, double scale, TextureEncoding texture_encoding,
                              TextureFilter texture_filter) {
  return ModelImport(file, scale, texture_encoding, texture_filter).run();
}

}  // namespace sturm
