#pragma once
#include <emscripten/val.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace sturm::viewer {

// Results as the page gets them. Arrays are copies: memory of the core moves when it grows.

inline emscripten::val copy_of(const std::vector<float>& numbers) {
  return emscripten::val::global("Float32Array")
      .new_(emscripten::val(emscripten::typed_memory_view(numbers.size(), numbers.data())));
}
inline emscripten::val copy_of(const std::vector<std::uint8_t>& numbers) {
  return emscripten::val::global("Uint8Array")
      .new_(emscripten::val(emscripten::typed_memory_view(numbers.size(), numbers.data())));
}

/// Null where there is none and where it is not finite.
inline emscripten::val number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? emscripten::val(*value) : emscripten::val::null();
}

template <class... Numbers>
emscripten::val list_of(Numbers... numbers) {
  emscripten::val list = emscripten::val::array();
  (list.call<void>("push", double(numbers)), ...);
  return list;
}

inline emscripten::val list_of(const Eigen::Vector3d& v) {
  return list_of(v.x(), v.y(), v.z());
}

/// Row by row.
inline emscripten::val rows_of(const Eigen::Matrix2d& m) {
  return list_of(m(0, 0), m(0, 1), m(1, 0), m(1, 1));
}

}  // namespace sturm::viewer
