#include "pathtrace/scene/assimp_import.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
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

#include "io/files/error.h"
#include "io/images/image_formats.h"
#include "io/images/tone_map.h"
#include "pathtrace/scene/collada_check.h"
#include "pathtrace/scene/gltf/gltf_import.h"
#include "pathtrace/scene/obj_references.h"
#include "pathtrace/scene/texture_file.h"
#include "pathtrace/scene/vertex_normals.h"

namespace sturm {
namespace {

class ModelImport {
 public:
  explicit ModelImport(const ModelSpec& spec) : spec_(spec), file_(spec.file), scale_(spec.scale) {}

  SceneDescription run() {
    if (!std::filesystem::is_regular_file(file_)) fail("", "", "a model file that exists");
    if (!(scale_ > 0.0 && std::isfinite(scale_))) fail("scale", std::to_string(scale_), "a positive number");
    const std::string extension = lower_case_extension();
    if (extension == ".gltf" || extension == ".glb" || extension == ".vrm") return import_gltf(spec_);
    if (extension == ".obj") check_obj_references(file_);
    if (extension == ".dae") check_collada(file_);
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // No JoinIdenticalVertices: positions stay exactly those of the file, and flat shading needs no shared vertices.
    const aiScene* scene = importer.ReadFile(file_.string(), aiProcess_Triangulate | aiProcess_SortByPType);
    if (!scene || !scene->mRootNode) fail("", importer.GetErrorString(), "a model that Assimp can read");
    // A library may define more than the model uses: textures nobody sees are not loaded.
    std::vector<bool> used(scene->mNumMaterials, false);
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) used.at(scene->mMeshes[i]->mMaterialIndex) = true;
    for (unsigned i = 0; i < scene->mNumMaterials; ++i) add_material(*scene, *scene->mMaterials[i], used[i]);
    shown_.assign(scene->mNumMeshes, 0);
    prototype_of_.assign(scene->mNumMeshes, -1);
    count_shown(*scene->mRootNode);
    add_node(*scene, *scene->mRootNode, aiMatrix4x4());
    note_what_is_left_out(*scene, used);
    if (result_.meshes.empty() && result_.instances.empty())
      fail("", "no triangles", "a model with at least one triangle");
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

  Eigen::Vector3f checked_colour(const aiColor3D& colour, float largest, const std::string& where,
                                 const std::string& expected) const {
    for (const float value : {colour.r, colour.g, colour.b})
      if (!(value >= 0.0f && value <= largest && std::isfinite(value))) fail(where, std::to_string(value), expected);
    return {colour.r, colour.g, colour.b};
  }

  void add_material(const aiScene& scene, const aiMaterial& source, bool used) {
    Material material;
    material.name = source.GetName().C_Str();
    const std::string where = "material \"" + material.name + "\"";
    aiColor3D base(0, 0, 0), emission(0, 0, 0);
    if (source.Get(AI_MATKEY_BASE_COLOR, base) != aiReturn_SUCCESS) source.Get(AI_MATKEY_COLOR_DIFFUSE, base);
    float strength = 1.0f;
    source.Get(AI_MATKEY_COLOR_EMISSIVE, emission);
    source.Get(AI_MATKEY_EMISSIVE_INTENSITY, strength);
    material.albedo = checked_colour(base, 1.0f, where + ", base colour", "reflectances from 0 to 1");
    material.emission = checked_colour(emission * strength, std::numeric_limits<float>::max(), where + ", emission",
                                       "a finite radiance of at least 0");
    aiString path;
    if (used && (source.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == aiReturn_SUCCESS ||
                 source.GetTexture(aiTextureType_DIFFUSE, 0, &path) == aiReturn_SUCCESS))
      material.albedo_texture = texture(scene, path.C_Str(), where, spec_.texture_encoding);
    material.nearest_filter = spec_.texture_filter == TextureFilter::Nearest;
    material.albedo_mapping.wrap_u = material.albedo_mapping.wrap_v = spec_.texture_wrap.value_or(TextureWrap::Clamp);
    result_.materials.push_back(std::move(material));
  }

  /// The picture of a name in the model: a file beside it, or "*0" and so on, embedded in it.
  Image linear_texture(const aiScene& scene, const std::string& name, const std::string& where,
                       TextureEncoding encoding) {
    if (const aiTexture* embedded = scene.GetEmbeddedTexture(name.c_str())) {
      if (embedded->mHeight != 0) fail(where, "an embedded texture of plain texels", "an embedded PNG or JPEG file");
      const Image stored =
          read_embedded_image({reinterpret_cast<const unsigned char*>(embedded->pcData), embedded->mWidth},
                              file_.string() + ", " + where + ", texture " + name);
      return encoding == TextureEncoding::Srgb ? srgb_to_linear(stored) : stored;
    }
    const auto path = file_.parent_path() / name;
    if (!std::filesystem::is_regular_file(path)) fail(where, path.string(), "a texture file that exists");
    std::vector<std::string> notes;
    Image picture = read_texture(path, encoding, notes);
    for (const std::string& text : notes) note(text);
    return picture;
  }

  std::shared_ptr<const Image> texture(const aiScene& scene, std::string name, const std::string& where,
                                       TextureEncoding encoding) {
    std::replace(name.begin(), name.end(), '\\', '/');  // model files from Windows
    std::shared_ptr<const Image>& known = textures_[{name, encoding}];
    if (known) return known;
    const Image stored = linear_texture(scene, name, where, encoding);
    Image rgb(stored.width, stored.height, 3);
    const bool grey = stored.channels <= 2;
    for (int y = 0; y < rgb.height; ++y)
      for (int x = 0; x < rgb.width; ++x)
        for (int c = 0; c < 3; ++c) rgb.at(x, y)[c] = stored.at(x, y)[grey ? 0 : c];
    return known = std::make_shared<const Image>(std::move(rgb));
  }

  void note(const std::string& text) { result_.notes.push_back(file_.filename().string() + ": " + text); }

  void note_what_is_left_out(const aiScene& scene, const std::vector<bool>& used) {
    if (scene.mNumLights) note(std::to_string(scene.mNumLights) + " lights of the file are left out");
    if (scene.mNumCameras) note(std::to_string(scene.mNumCameras) + " cameras of the file are left out");
    if (scene.mNumAnimations) note("animations are left out: everything stands as at the start");
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
      if (scene.mMeshes[i]->HasBones())
        note("mesh \"" + std::string(scene.mMeshes[i]->mName.C_Str()) + "\": its skeleton is left out");
    for (unsigned i = 0; i < scene.mNumMaterials; ++i)
      if (used[i]) note_material(*scene.mMaterials[i], result_.materials[i].surface);
  }

  void note_material(const aiMaterial& source, const SurfaceModel& surface) {
    std::string left_out;
    const auto add = [&](const char* what) { left_out += (left_out.empty() ? "" : ", ") + std::string(what); };
    float value = 0.0f;
    aiColor3D colour(0, 0, 0);
    const bool lambert = std::holds_alternative<Diffuse>(surface);
    if (lambert && source.Get(AI_MATKEY_METALLIC_FACTOR, value) == aiReturn_SUCCESS && value > 0.0f) add("metallic");
    if (lambert && source.Get(AI_MATKEY_COLOR_SPECULAR, colour) == aiReturn_SUCCESS && !colour.IsBlack())
      add("specular");
    if (source.Get(AI_MATKEY_OPACITY, value) == aiReturn_SUCCESS && value < 1.0f) add("transparency");
    if (source.Get(AI_MATKEY_TRANSMISSION_FACTOR, value) == aiReturn_SUCCESS && value > 0.0f) add("transmission");
    for (const auto& [type, name] : {std::pair{aiTextureType_NORMALS, "normal map"},
                                     {aiTextureType_HEIGHT, "bump map"},
                                     {aiTextureType_EMISSIVE, "emission texture"},
                                     {aiTextureType_OPACITY, "opacity texture"},
                                     {aiTextureType_SPECULAR, "specular texture"},
                                     {aiTextureType_DISPLACEMENT, "displacement"}})
      if (source.GetTextureCount(type) > 0) add(name);
    if (!left_out.empty())
      note("material \"" + std::string(source.GetName().C_Str()) + "\" is taken " + (lambert ? "as Lambert " : "") +
           "without its " + left_out);
  }

  void count_shown(const aiNode& node) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) ++shown_.at(node.mMeshes[i]);
    for (unsigned i = 0; i < node.mNumChildren; ++i) count_shown(*node.mChildren[i]);
  }

  void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& world_from_parent) {
    const aiMatrix4x4 world_from_node = world_from_parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      place_mesh(*scene.mMeshes[node.mMeshes[i]], node.mMeshes[i], world_from_node);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], world_from_node);
  }

  /// A mesh in place, or an instance of its prototype.
  void place_mesh(const aiMesh& source, unsigned index, const aiMatrix4x4& world_from_node) {
    const bool emits = result_.materials.at(source.mMaterialIndex).emission.maxCoeff() > 0.0f;
    if (shown_[index] < 2 || emits) {
      if (Mesh mesh = converted(source, world_from_node); !mesh.triangles.empty())
        result_.meshes.push_back(std::move(mesh));
      return;
    }
    if (prototype_of_[index] < 0) {
      Mesh mesh = converted(source, aiMatrix4x4());
      if (mesh.triangles.empty()) return;
      prototype_of_[index] = static_cast<int>(result_.prototypes.size());
      result_.prototypes.push_back(std::move(mesh));
    }
    const aiMatrix4x4& m = world_from_node;
    const float scale = static_cast<float>(scale_);  // the prototype's positions are scaled already
    Instance instance{prototype_of_[index], {}};
    instance.world_from_prototype << m.a1, m.a2, m.a3, scale * m.a4, m.b1, m.b2, m.b3, scale * m.b4, m.c1, m.c2, m.c3,
        scale * m.c4;
    if (!instance.world_from_prototype.allFinite())
      fail("mesh \"" + result_.prototypes.back().name + "\"", "a transformation that is not finite",
           "finite transformations");
    result_.instances.push_back(instance);
  }

  Mesh converted(const aiMesh& source, const aiMatrix4x4& world_from_node) const {
    Mesh mesh;
    mesh.name = source.mName.C_Str();
    mesh.material = static_cast<int>(source.mMaterialIndex);
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = world_from_node * source.mVertices[i];
      const Eigen::Vector3f position = (scale_ * Eigen::Vector3d(p.x, p.y, p.z)).cast<float>();
      if (!position.allFinite())
        fail("mesh \"" + mesh.name + "\"", "vertex " + std::to_string(i) + " is not finite", "finite positions");
      mesh.positions.push_back(position);
      if (!source.HasTextureCoords(0)) continue;
      const Eigen::Vector2f uv(source.mTextureCoords[0][i].x, source.mTextureCoords[0][i].y);
      if (!uv.allFinite())
        fail("mesh \"" + mesh.name + "\"", "texture coordinate " + std::to_string(i) + " is not finite",
             "finite coordinates");
      mesh.texture_coordinates.push_back(uv);
    }
    const bool mirrored = world_from_node.Determinant() < 0.0f;
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
      const aiFace& face = source.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines that share a mesh with triangles
      std::array<std::uint32_t, 3> triangle{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
      if (*std::max_element(triangle.begin(), triangle.end()) >= source.mNumVertices)
        fail("mesh \"" + mesh.name + "\"", "face " + std::to_string(f) + " names a vertex that does not exist",
             "valid vertex numbers");
      if (mirrored) std::swap(triangle[1], triangle[2]);
      mesh.triangles.push_back(triangle);
    }
    if (source.HasNormals()) mesh.normals = vertex_normals(source, world_from_node, mesh);
    return mesh;
  }

  static std::vector<Eigen::Vector3f> vertex_normals(const aiMesh& source, const aiMatrix4x4& world_from_node,
                                                     const Mesh& mesh) {
    aiMatrix3x3 turn(world_from_node);
    turn.Inverse().Transpose();
    std::vector<Eigen::Vector3d> normals;
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D n = turn * source.mNormals[i];
      normals.emplace_back(n.x, n.y, n.z);
    }
    return normals_that_bend(normals, mesh);
  }

  const ModelSpec& spec_;
  const std::filesystem::path& file_;
  double scale_;
  std::vector<unsigned> shown_;    // by how many nodes each mesh is
  std::vector<int> prototype_of_;  // −1: none yet
  std::map<std::pair<std::string, TextureEncoding>, std::shared_ptr<const Image>> textures_;
  SceneDescription result_;
};

}  // namespace

SceneDescription import_model(const ModelSpec& spec) {
  return ModelImport(spec).run();
}

}  // namespace sturm
