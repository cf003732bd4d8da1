#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "pathtrace/scene/gltf/materials.h"
#include "pathtrace/scene/gltf/skin.h"

namespace sturm::gltf {

/// A primitive as the file has it: attributes by vertex, triangles whose corners are among them. Vertices that no
/// triangle has are left out; the others keep their order.
struct Primitive {
  std::string name;
  PlacedMaterial material;
  std::vector<Eigen::Vector3f> positions;                          ///< in the mesh's own frame [units of the file]
  std::vector<Eigen::Vector3f> normals;                            ///< of any length; or empty
  std::vector<Eigen::Vector2f> coordinates, emission_coordinates;  ///< v upwards; or empty
  std::vector<Eigen::Vector4f> colours;                            ///< or empty
  std::vector<VertexPose> poses;                                   ///< by which joints a skin moves it; or empty
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Which of a file's primitives is read, and how.
struct PrimitiveRequest {
  std::size_t mesh = 0, number = 0;
  std::vector<double> morph_weights{};  ///< of the targets; fewer: the others are 0
  bool skinned = false;
};

/// Reads primitives: triangles, strips and fans; attributes of any component type; morph targets; colours.
class PrimitiveReader {
 public:
  PrimitiveReader(const Document& document, Materials& materials, std::vector<std::string>& notes)
      : document_(document), materials_(materials), notes_(notes) {}

  /// None where it has no triangles (points, lines), which is noted. Throws InputError.
  std::optional<Primitive> read(const PrimitiveRequest& request);

 private:
  struct Place;
  Elements morphed(const Place& place, const std::string& attribute, std::size_t least, std::size_t most) const;
  void read_coordinates(const Place& place, Primitive& result);
  void read_colours(const Place& place, Primitive& result);
  void read_poses(const Place& place, Primitive& result) const;
  std::vector<Eigen::Vector2f> coordinates(const Place& place, std::size_t set);
  void note(const std::string& text);

  const Document& document_;
  Materials& materials_;
  std::vector<std::string>& notes_;
};

}  // namespace sturm::gltf
