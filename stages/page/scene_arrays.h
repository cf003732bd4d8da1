#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// The data of a viewer's scene, and how its header names them (docs/formats/viewer_scene.md).
class SceneArrays {
 public:
  /// Appends `numbers`, `components` of them for each element. Returns {"at", "type", "components", "count"}.
  Json add(const std::vector<float>& numbers, int components);
  Json add(const std::vector<std::uint32_t>& numbers, int components);
  Json add(const std::vector<std::uint16_t>& numbers, int components);
  Json add(const std::vector<std::uint8_t>& numbers, int components);

  const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  Json append(const std::vector<Number>& numbers, int components, const char* type);

  std::string bytes_;
};

/// Header and data as one file.
std::string scene_file(const Json& header, const SceneArrays& arrays);

}  // namespace sturm
