#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "io/specs/texture_wrap.h"

namespace sturm {

/// What a material of a COLLADA file states beside what Assimp tells of it.
struct ColladaMaterial {
  bool has_specular = false;   ///< a specular part that is not black: Assimp has one of its own for all
  bool is_constant = false;    ///< shines alone and reflects nothing
  bool has_parameter = false;  ///< its diffuse colour is that of a parameter, which Assimp does not follow
  bool has_border = false;     ///< its texture ends in a colour of its own
  TextureWrap wrap_u = TextureWrap::Repeat, wrap_v = TextureWrap::Repeat;  ///< of its diffuse texture
};

/// The materials of a COLLADA file by their ids and names.
std::map<std::string, ColladaMaterial> collada_materials(const std::filesystem::path& file);

}  // namespace sturm
