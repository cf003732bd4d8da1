#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace sturm::gltf {

/// Bytes of a `componentType` [glTF 2.0 specification, section 3.6.2.2].
inline std::optional<std::uint64_t> bytes_of_component(std::uint64_t component_type) {
  switch (component_type) {
    case 5120:  // BYTE
    case 5121:  // UNSIGNED_BYTE
      return 1;
    case 5122:  // SHORT
    case 5123:  // UNSIGNED_SHORT
      return 2;
    case 5125:  // UNSIGNED_INT
    case 5126:  // FLOAT
      return 4;
    default:
      return std::nullopt;
  }
}

/// Numbers in an element of a `type`.
inline std::optional<std::uint64_t> components_of_type(std::string_view type) {
  struct Type {
    std::string_view name;
    std::uint64_t components;
  };
  for (const auto& [name, components] : {Type{"SCALAR", 1}, Type{"VEC2", 2}, Type{"VEC3", 3}, Type{"VEC4", 4},
                                         Type{"MAT2", 4}, Type{"MAT3", 9}, Type{"MAT4", 16}})
    if (type == name) return components;
  return std::nullopt;
}

}  // namespace sturm::gltf
