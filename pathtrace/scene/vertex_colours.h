#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "io/specs/scene_spec.h"

namespace sturm {

/// Vertex colours of a file (red, green, blue from 0 to 1) as linear ones, decoded as its textures are.
void decode_vertex_colours(std::vector<Eigen::Vector3f>& colours, TextureEncoding encoding);

/// The same of colours whose white the file does not state: where one is above 1 it is 255. Returns what the notes say
/// of them. Throws InputError that names the file for colours out of range.
std::string decode_stated_colours(std::vector<Eigen::Vector3f>& colours, TextureEncoding encoding,
                                  const std::filesystem::path& file);

/// What the notes say of vertex colours.
std::string note_of_vertex_colours(TextureEncoding encoding);

}  // namespace sturm
