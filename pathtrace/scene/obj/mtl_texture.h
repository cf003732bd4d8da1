#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pathtrace/scene/named_files.h"

namespace sturm {

/// A texture of an MTL file: options and the name of a file.
struct MtlTexture {
  std::string name;                                       ///< as it is written
  std::optional<NamedFiles::Found> found;                 ///< none where no such file exists
  Eigen::Vector2f scale{1.0f, 1.0f}, offset{0.0f, 0.0f};  ///< coordinates in the picture are scale · (u, v) + offset
  std::optional<bool> clamped;                            ///< -clamp
  char channel = 0;                                       ///< -imfchan: r, g, b, m, l or z; 0: not stated
  std::vector<std::string> left_out;                      ///< options that change the picture and are not applied
};

/// Reads what stands behind `map_Kd` and the like. Options may stand before or behind the name and have fewer numbers
/// than they may have. Names may hold blanks and begin with a minus sign or a number: of the ways to read the text, the
/// first whose file exists is taken.
MtlTexture read_mtl_texture(const std::string& text, const NamedFiles& files);

}  // namespace sturm
