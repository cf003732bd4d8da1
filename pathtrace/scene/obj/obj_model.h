#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace sturm {

/// What an OBJ file says, as it stands there: nothing is moved, rounded or loaded.
struct ObjModel {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Numbers of a corner's position, texture coordinate and normal, from 0.
  struct Corner {
    std::uint32_t position = none, texture = none, normal = none;
  };

  /// The faces of one object and group that have one material and the same kind of corners.
  struct Part {
    std::string object, groups;                     ///< as `o` and `g` name them; "" where they do not
    int material = -1;                              ///< index into `used_materials`; −1 before any `usemtl`
    bool has_texture = false, has_normals = false;  ///< all corners have them; else none is taken
    std::vector<std::array<Corner, 3>> triangles;
  };

  /// A name behind `usemtl`, with the line that says it first.
  struct MaterialUse {
    std::string name;
    long line;
  };
  /// The text behind `mtllib`: one name or several.
  struct LibraryUse {
    std::string names;
    long line;
  };

  std::vector<Eigen::Vector3d> positions;  ///< in units of the file
  std::vector<Eigen::Vector2f> texture_coordinates;
  std::vector<Eigen::Vector3f> normals;  ///< of any length; zero where the file has no finite numbers
  std::vector<Eigen::Vector3f> colours;  ///< one per position, or empty; as in the file; white where it has none
  std::vector<Part> parts;               ///< in the order in which the file begins them
  std::vector<MaterialUse> used_materials;
  std::vector<LibraryUse> libraries;
  std::vector<std::string> left_out;  ///< what is not read, in words
};

/// Reads the statements v, vt, vn, f, o, g, usemtl and mtllib in any case of letters; every other one is passed over,
/// and lines, points and free-form surfaces are listed in `left_out`.
///
/// - Numbers are read in double. Negative numbers of vertices count from the last one backwards; positive ones may name
///   vertices that follow.
/// - `v x y z`, `v x y z w` with w = 1, `v x y z r g b` and `v x y z r g b a`.
/// - Polygons become triangles with the same winding, also where they are not convex. A face with fewer than three
///   corners has no area and is passed over.
///
/// Throws InputError that names the file and the line.
ObjModel read_obj(const std::filesystem::path& file);

}  // namespace sturm
