#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sturm {

/// What a PLY file says, as it stands there: nothing is moved, rounded or loaded.
struct PlyModel {
  std::vector<Eigen::Vector3d> positions;  ///< in units of the file, finite
  bool rounded = false;                    ///< positions are stored in single precision
  std::vector<Eigen::Vector3f> normals;    ///< one per position, or empty; of any length, zero where not finite
  std::vector<Eigen::Vector2f> texture_coordinates;  ///< one per position, or empty
  std::vector<Eigen::Vector3f> colours;  ///< one per position, or empty; whole numbers as parts of their white
                                         ///< (255, of ushort 65535), others as in the file
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< numbers of positions
  std::vector<std::array<Eigen::Vector2f, 3>>
      corner_coordinates;             ///< one per triangle, or empty: stated with the faces
  std::vector<std::string> textures;  ///< files that comments name
  std::vector<std::string> left_out;  ///< what is not read, in words
};

/// Reads the elements `vertex`, `face` and `tristrips` of a PLY file, which is text or binary of either order of bytes;
/// others are passed over.
///
/// - Of vertices: x y z; nx ny nz; u v, s t or texture_u texture_v; red green blue. Numbers of any type, read in
/// double.
/// - Of faces: the list vertex_indices (or vertex_index), and the list texcoord with two numbers for each corner.
/// - Polygons become triangles with the same winding, also where they are not convex. A face with fewer than three
///   corners has no area and is passed over. In triangle strips −1 begins the next one.
///
/// Throws InputError that names the file and the line or byte.
PlyModel read_ply(const std::filesystem::path& file);

}  // namespace sturm
