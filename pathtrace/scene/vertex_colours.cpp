#include "pathtrace/scene/vertex_colours.h"

#include <algorithm>

#include "io/files/error.h"
#include "io/images/tone_map.h"
#include "pathtrace/scene/message_text.h"

namespace sturm {

void decode_vertex_colours(std::vector<Eigen::Vector3f>& colours, TextureEncoding encoding) {
  if (encoding == TextureEncoding::Linear) return;
  for (Eigen::Vector3f& colour : colours)
    for (float& value : colour) value = srgb_to_linear(value);
}

std::string decode_stated_colours(std::vector<Eigen::Vector3f>& colours, TextureEncoding encoding,
                                  const std::filesystem::path& file) {
  float largest = 0.0f;
  for (const Eigen::Vector3f& colour : colours) largest = std::max(largest, colour.maxCoeff());
  const float white = largest > 1.0f ? 255.0f : 1.0f;
  for (Eigen::Vector3f& colour : colours) {
    if (!(colour.minCoeff() >= 0.0f && colour.maxCoeff() <= white))
      throw InputError(file.string(), "vertex colours",
                       exact_number(colour.minCoeff() < 0.0f ? colour.minCoeff() : colour.maxCoeff()),
                       "numbers from 0 to 1, or from 0 to 255");
    colour /= white;
  }
  decode_vertex_colours(colours, encoding);
  return note_of_vertex_colours(encoding) + (white > 1.0f ? ", with 255 as white" : "");
}

std::string note_of_vertex_colours(TextureEncoding encoding) {
  return std::string("vertex colours multiply the base colour; they are taken as ") +
         (encoding == TextureEncoding::Srgb ? "sRGB" : "linear") + " (texture_encoding)";
}

}  // namespace sturm
