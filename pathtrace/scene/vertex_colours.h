#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/specs/scene_spec.h"

namespace sturm {

/// Vertex colours of a file (red, green, blue from 0 to 1) as linear ones, decoded as its textures are.
void decode_vertex_colours(std::vector<Eigen::Vector3f>& colours, TextureEncoding encoding);

/// What the notes say of them.
std::string note_of_vertex_colours(TextureEncoding encoding);

}  // namespace sturm
