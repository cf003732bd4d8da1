#include "pathtrace/scene/assimp_import.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/sandbox.h"
#include "pathtrace/scene/assimp_positions.h"
#include "pathtrace/scene/collada_check.h"
#include "pathtrace/scene/collada_materials.h"
#include "pathtrace/scene/gltf/gltf_import.h"
#include "pathtrace/scene/lost_precision.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/model_placement.h"
#include "pathtrace/scene/named_files.h"
#include "pathtrace/scene/obj/obj_import.h"
#include "pathtrace/scene/ply/ply_import.h"
#include "pathtrace/scene/texture_file.h"
#include "pathtrace/scene/unstated_reflectance.h"
#include "pathtrace/scene/vertex_colours.h"
#include "pathtrace/scene/vertex_normals.h"

namespace Assimp {

/// Debian's Assimp checks some files by assertions, which would end the program. This takes the place of its function;
/// Assimp catches the exception and says that it cannot read the file.
[[noreturn]] void aiAssertViolation(const char* condition, const char*, int) {
  throw std::runtime_error(std::string("Assimp's condition \"") + condition + "\" does not hold");
}

}  // namespace Assimp

namespace sturm {
namespace {

class ModelImport {
 public:
  explicit ModelImport(const ModelSpec& spec) : spec_(spec), file_(spec.file), placement_(spec) {}

  SceneDescription run(const std::string& extension) {
    if (extension == ".dae") check_collada(file_);
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // No JoinIdenticalVertices: positions stay exactly those of the file, and flat shading needs no shared vertices.
    constexpr unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType;
    const aiScene* scene = checked(importer, importer.ReadFile(file_.string(), 0));
    scene = checked(importer, importer.ApplyPostProcessing(steps));
    if (AssimpPositions::are_far_from_the_origin(*scene)) scene = positions_.read(importer, *scene, file_, steps);
    if (!scene || !scene->mRootNode) fail("", importer.GetErrorString(), "a model that Assimp can read");
    if (extension == ".dae") collada_ = collada_materials(file_);
    has_materials_ = extension != ".stl";
    // A library may define more than the model uses: textures nobody sees are not loaded.
    std::vector<bool> used(scene->mNumMaterials, false);
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) used.at(scene->mMeshes[i]->mMaterialIndex) = true;
    for (unsigned i = 0; i < scene->mNumMaterials; ++i) add_material(*scene, *scene->mMaterials[i], used[i]);
    if (!has_materials_) apply_default_material(*scene);
    shown_.assign(scene->mNumMeshes, 0);
    prototype_of_.assign(scene->mNumMeshes, -1);
    count_shown(*scene->mRootNode);
    add_node(*scene, *scene->mRootNode, Eigen::Matrix4d::Identity());
    note_what_is_left_out(*scene, used);
    if (result_.meshes.empty() && result_.instances.empty())
      fail("", "no triangles", "a model with at least one triangle");
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& value, const std::string& expected) const {
    throw InputError(file_.string(), where, value, expected);
  }

  /// Assimp's further steps believe what faces say about vertices.
  const aiScene* checked(const Assimp::Importer& importer, const aiScene* scene) const {
    if (!scene || !scene->mRootNode) fail("", importer.GetErrorString(), "a model that Assimp can read");
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
      const aiMesh& mesh = *scene->mMeshes[m];
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        if (mesh.mFaces[f].mNumIndices == 0)
          fail("mesh " + in_quotes(mesh.mName.C_Str()), "face " + std::to_string(f) + " has no vertices",
               "faces of one vertex or more");
        for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i)
          if (mesh.mFaces[f].mIndices[i] >= mesh.mNumVertices)
            fail("mesh " + in_quotes(mesh.mName.C_Str()),
                 "face " + std::to_string(f) + " names a vertex that does not exist", "valid vertex numbers");
      }
    }
    return scene;
  }

  Eigen::Vector3f checked_colour(const aiColor3D& colour, float largest, const std::string& where,
                                 const std::string& expected) const {
    for (const float value : {colour.r, colour.g, colour.b})
      if (!(value >= 0.0f && value <= largest && std::isfinite(value))) fail(where, exact_number(value), expected);
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
    if (stated(material.name).is_constant) material.albedo.setZero();
    material.nearest_filter = spec_.texture_filter == TextureFilter::Nearest;
    uv_sets_.push_back(0);
    if (used) add_texture(scene, source, where, material);
    result_.materials.push_back(std::move(material));
  }

  void add_texture(const aiScene& scene, const aiMaterial& source, const std::string& where, Material& material) {
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      aiString path;
      unsigned set = 0;
      if (source.GetTexture(type, 0, &path, nullptr, &set) != aiReturn_SUCCESS) continue;
      material.albedo_texture = texture(scene, path.C_Str(), where, spec_.texture_encoding);
      uv_sets_.back() = set;
      break;
    }
    const ColladaMaterial& file = stated(material.name);
    material.albedo_mapping.wrap_u = spec_.texture_wrap.value_or(collada_ ? file.wrap_u : TextureWrap::Clamp);
    material.albedo_mapping.wrap_v = spec_.texture_wrap.value_or(collada_ ? file.wrap_v : TextureWrap::Clamp);
  }

  /// What a COLLADA file states of a material; its defaults for other files and names.
  const ColladaMaterial& stated(const std::string& material) const {
    static const ColladaMaterial defaults;
    if (!collada_) return defaults;
    const auto at = collada_->find(material);
    return at == collada_->end() ? defaults : at->second;
  }

  /// A file without materials (STL) has the grey of all models without, or white under the colours of its vertices.
  void apply_default_material(const aiScene& scene) {
    for (Material& material : result_.materials) material.albedo.setConstant(unstated_reflectance);
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
      if (scene.mMeshes[i]->HasVertexColors(0)) result_.materials[scene.mMeshes[i]->mMaterialIndex].albedo.setOnes();
  }

  /// The picture of a name in the model: a file beside it, or "*0" and so on, embedded in it.
  Image linear_texture(const aiScene& scene, const std::string& name, const std::string& where,
                       TextureEncoding encoding) {
    std::vector<std::string> notes;
    Image picture;
    if (const aiTexture* embedded = scene.GetEmbeddedTexture(name.c_str())) {
      if (embedded->mHeight != 0) fail(where, "an embedded texture of plain texels", "an embedded PNG or JPEG file");
      picture =
          read_embedded_texture({reinterpret_cast<const unsigned char*>(embedded->pcData), embedded->mWidth}, encoding,
                                StatedIn::Picture, file_.string() + ", " + where + ", texture " + name, notes);
    } else {
      const NamedFiles files({file_.parent_path()});
      const auto found = files.find(name);
      if (!found) fail(where, files.expected(name).string(), "a texture file that exists");
      picture = read_texture(found->file, encoding, StatedIn::Picture, notes);
    }
    for (const std::string& text : notes) note(text);
    return picture;
  }

  std::shared_ptr<const Image> texture(const aiScene& scene, const std::string& name, const std::string& where,
                                       TextureEncoding encoding) {
    std::shared_ptr<const Image>& known = textures_[{name, encoding}];
    if (!known) known = colours_of(linear_texture(scene, name, where, encoding));
    return known;
  }

  void note(const std::string& text) { result_.notes.push_back(file_.filename().string() + ": " + text); }

  void note_what_is_left_out(const aiScene& scene, const std::vector<bool>& used) {
    if (scene.mNumLights) note(std::to_string(scene.mNumLights) + " lights of the file are left out");
    if (scene.mNumCameras) note(std::to_string(scene.mNumCameras) + " cameras of the file are left out");
    if (scene.mNumAnimations) note("animations are left out: everything stands as at the start");
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) note_mesh(*scene.mMeshes[i]);
    if (std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, [](auto* m) { return m->HasVertexColors(0); }))
      note(note_of_vertex_colours(spec_.texture_encoding));
    for (unsigned i = 0; i < scene.mNumMaterials; ++i)
      if (used[i]) note_material(*scene.mMaterials[i], result_.materials[i].surface);
  }

  void note_mesh(const aiMesh& mesh) {
    const std::string name = "mesh " + in_quotes(mesh.mName.C_Str()) + ": ";
    if (mesh.HasBones()) note(name + "its skeleton is left out");
    if (const unsigned wanted = uv_sets_.at(mesh.mMaterialIndex); wanted != uv_set(mesh) && mesh.HasTextureCoords(0))
      note(name + "its first texture coordinates are taken, not " + std::to_string(wanted));
  }

  static bool has_highlights(const aiMaterial& source) {
    int shading = aiShadingMode_Phong;
    source.Get(AI_MATKEY_SHADING_MODEL, shading);
    return shading != aiShadingMode_Flat && shading != aiShadingMode_Gouraud && shading != aiShadingMode_NoShading;
  }

  void note_material(const aiMaterial& source, const SurfaceModel& surface) {
    std::string left_out;
    const auto add = [&](const char* what) { left_out += (left_out.empty() ? "" : ", ") + std::string(what); };
    float value = 0.0f;
    aiColor3D colour(0, 0, 0);
    const bool lambert = std::holds_alternative<Diffuse>(surface);
    const std::string name = source.GetName().C_Str();
    // Assimp has a specular colour of its own for files that state none.
    const bool specular = collada_ ? stated(name).has_specular : has_materials_ && has_highlights(source);
    if (lambert && source.Get(AI_MATKEY_METALLIC_FACTOR, value) == aiReturn_SUCCESS && value > 0.0f) add("metallic");
    if (lambert && specular && source.Get(AI_MATKEY_COLOR_SPECULAR, colour) == aiReturn_SUCCESS && !colour.IsBlack())
      add("specular");
    if (source.Get(AI_MATKEY_OPACITY, value) == aiReturn_SUCCESS && value < 1.0f) add("transparency");
    if (source.Get(AI_MATKEY_TRANSMISSION_FACTOR, value) == aiReturn_SUCCESS && value > 0.0f) add("transmission");
    for (const auto& [type, map] : {std::pair{aiTextureType_NORMALS, "normal map"},
                                    {aiTextureType_HEIGHT, "bump map"},
                                    {aiTextureType_EMISSIVE, "emission texture"},
                                    {aiTextureType_OPACITY, "opacity texture"},
                                    {aiTextureType_SPECULAR, "specular texture"},
                                    {aiTextureType_DISPLACEMENT, "displacement"}})
      if (source.GetTextureCount(type) > 0) add(map);
    if (stated(name).has_parameter) note("material " + in_quotes(name) + ": the parameter of its colour is not read");
    if (stated(name).has_border && !spec_.texture_wrap)
      note("material " + in_quotes(name) + ": its texture is clamped without a border");
    if (!left_out.empty())
      note("material \"" + name + "\" is taken " + (lambert ? "as Lambert " : "") + "without its " + left_out);
  }

  void count_shown(const aiNode& node) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) ++shown_.at(node.mMeshes[i]);
    for (unsigned i = 0; i < node.mNumChildren; ++i) count_shown(*node.mChildren[i]);
  }

  void add_node(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& world_from_parent) {
    const Eigen::Matrix4d world_from_node = world_from_parent * matrix_of(node);
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      place_mesh(*scene.mMeshes[node.mMeshes[i]], node.mMeshes[i], world_from_node);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], world_from_node);
  }

  static Eigen::Matrix4d matrix_of(const aiNode& node) {
    using RowByRow = Eigen::Matrix<ai_real, 4, 4, Eigen::RowMajor>;
    return Eigen::Map<const RowByRow>(&node.mTransformation.a1).cast<double>();
  }

  /// Of a node in the scene: what its points are multiplied with, and where its origin stands.
  struct Frame {
    Eigen::Matrix3d linear;
    Eigen::Vector3d origin;

    Eigen::Vector3d point(const Eigen::Vector3d& p) const { return linear * p + origin; }
  };

  Frame placed(const Eigen::Matrix4d& file_from_node) const {
    return {placement_.scale() * (placement_.turn() * file_from_node.topLeftCorner<3, 3>()),
            placement_.point(file_from_node.topRightCorner<3, 1>())};
  }

  /// A mesh in place, or an instance of its prototype.
  void place_mesh(const aiMesh& source, unsigned index, const Eigen::Matrix4d& file_from_node) {
    const bool emits = result_.materials.at(source.mMaterialIndex).emission.maxCoeff() > 0.0f;
    const Frame frame = placed(file_from_node);
    if (shown_[index] < 2 || emits) {
      if (Mesh mesh = converted(source, frame); !mesh.triangles.empty()) {
        note_lost_precision(source, mesh, file_from_node);
        result_.meshes.push_back(std::move(mesh));
      }
      return;
    }
    if (prototype_of_[index] < 0) {
      const double scale = placement_.scale();
      Mesh mesh = converted(source, {Eigen::Matrix3d(Eigen::Vector3d::Constant(scale).asDiagonal()), {0.0, 0.0, 0.0}});
      if (mesh.triangles.empty()) return;
      note_lost_precision(source, mesh, file_from_node);
      prototype_of_[index] = static_cast<int>(result_.prototypes.size());
      result_.prototypes.push_back(std::move(mesh));
    }
    Instance instance{prototype_of_[index], {}};  // the prototype's positions are scaled already
    instance.world_from_prototype.leftCols<3>() = (frame.linear / placement_.scale()).cast<float>();
    instance.world_from_prototype.col(3) = frame.origin.cast<float>();
    if (!instance.world_from_prototype.allFinite())
      fail("mesh \"" + result_.prototypes.back().name + "\"", "a transformation that is not finite",
           "finite transformations");
    result_.instances.push_back(instance);
  }

  /// Where single precision came in: at the positions in the scene, and where Assimp has rounded.
  void note_lost_precision(const aiMesh& source, const Mesh& mesh, const Eigen::Matrix4d& file_from_node) {
    const double rounded = placement_.scale() * positions_.largest_rounded(source, file_from_node);
    if (const std::string lost = lost_precision(mesh, std::max<double>(largest_coordinate_of(mesh), rounded));
        !lost.empty())
      note(lost);
  }

  /// The texture coordinates that the material's texture has; the first where they are not there.
  unsigned uv_set(const aiMesh& source) const {
    const unsigned wanted = uv_sets_.at(source.mMaterialIndex);
    return source.HasTextureCoords(wanted) ? wanted : 0;
  }

  Mesh converted(const aiMesh& source, const Frame& frame) const {
    Mesh mesh;
    mesh.name = source.mName.C_Str();
    mesh.material = static_cast<int>(source.mMaterialIndex);
    const unsigned set = uv_set(source);
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const Eigen::Vector3f position = frame.point(positions_.position(source, i)).cast<float>();
      if (!position.allFinite())
        fail("mesh \"" + mesh.name + "\"", "vertex " + std::to_string(i) + " is not finite", "finite positions");
      mesh.positions.push_back(position);
      if (!source.HasTextureCoords(set)) continue;
      const Eigen::Vector2f uv(source.mTextureCoords[set][i].x, source.mTextureCoords[set][i].y);
      if (!uv.allFinite())
        fail("mesh \"" + mesh.name + "\"", "texture coordinate " + std::to_string(i) + " is not finite",
             "finite coordinates");
      mesh.texture_coordinates.push_back(uv);
    }
    const bool mirrored = frame.linear.determinant() < 0.0;
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
    if (source.HasNormals()) mesh.normals = vertex_normals(source, frame, mesh);
    if (source.HasVertexColors(0)) mesh.vertex_colours = vertex_colours(source);
    return mesh;
  }

  std::vector<Eigen::Vector4f> vertex_colours(const aiMesh& source) const {
    std::vector<Eigen::Vector3f> colours;
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiColor4D& c = source.mColors[0][i];
      colours.push_back(checked_colour(
          {c.r, c.g, c.b}, 1.0f, "mesh " + in_quotes(source.mName.C_Str()) + ", vertex colour", "numbers from 0 to 1"));
    }
    decode_vertex_colours(colours, spec_.texture_encoding);
    std::vector<Eigen::Vector4f> with_alpha;
    for (unsigned i = 0; i < source.mNumVertices; ++i)
      with_alpha.push_back(Eigen::Vector4f(colours[i].x(), colours[i].y(), colours[i].z(), source.mColors[0][i].a));
    return with_alpha;
  }

  static std::vector<Eigen::Vector3f> vertex_normals(const aiMesh& source, const Frame& frame, const Mesh& mesh) {
    const Eigen::Matrix3d normal_from_node = frame.linear.inverse().transpose();
    std::vector<Eigen::Vector3d> normals;
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D& n = source.mNormals[i];
      normals.push_back(normal_from_node * Eigen::Vector3d(n.x, n.y, n.z));
    }
    return normals_that_bend(normals, mesh);
  }

  const ModelSpec& spec_;
  const std::filesystem::path& file_;
  ModelPlacement placement_;
  std::vector<unsigned> shown_;    // by how many nodes each mesh is
  std::vector<int> prototype_of_;  // −1: none yet
  std::map<std::pair<std::string, TextureEncoding>, std::shared_ptr<const Image>> textures_;
  AssimpPositions positions_;
  std::optional<std::map<std::string, ColladaMaterial>> collada_;  // what a COLLADA file states of its materials
  std::vector<unsigned> uv_sets_;  // of each material: the texture coordinates that its texture has
  bool has_materials_ = true;      // the format can state one
  SceneDescription result_;
};

}  // namespace

SceneDescription import_model(const ModelSpec& spec) {
  if (!std::filesystem::is_regular_file(spec.file))
    throw InputError(spec.file.string(), "", "", "a model file that exists");
  if (!(spec.scale > 0.0 && std::isfinite(spec.scale)))
    throw InputError(spec.file.string(), "scale", exact_number(spec.scale), "a positive number");
  const std::string extension = lower_case(spec.file.extension().string());
  if (extension == ".gltf" || extension == ".glb" || extension == ".vrm") return import_gltf(spec);
  if (extension == ".obj") return import_obj(spec);
  if (extension == ".ply") return import_ply(spec);
  // Of other formats Assimp opens whatever files they name.
  if (sandbox_is_on() && extension != ".stl" && extension != ".dae" && extension != ".fbx")
    throw InputError(spec.file.string(), "", extension, "with --sandbox .gltf, .glb, .obj, .dae, .fbx, .ply or .stl");
  return ModelImport(spec).run(extension);
}

}  // namespace sturm
