#include "pathtrace/scene/vertex_colours.h"

#include "io/images/tone_map.h"

namespace sturm {

void decode_vertex_colours(std::vector<Eigen::Vector3f>& colours, TextureEncoding encoding) {
  if (encoding == TextureEncoding::Linear) return;
  for (Eigen::Vector3f& colour : colours)
    for (float& value : colour) value = srgb_to_linear(value);
}

std::string note_of_vertex_colours(TextureEncoding encoding) {
  return std::string("vertex colours multiply the base colour; they are taken as ") +
         (encoding == TextureEncoding::Srgb ? "sRGB" : "linear") + " (texture_encoding)";
}

}  // namespace sturm
