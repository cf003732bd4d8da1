#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pathtrace/scene/gltf/document.h"

namespace sturm::gltf {

/// The elements of an accessor, one after the other.
struct Elements {
  std::size_t components = 0;  ///< numbers in an element
  std::vector<float> values;

  std::size_t count() const { return components ? values.size() / components : 0; }
  const float* at(std::size_t element) const { return &values[element * components]; }
};

/// Reads an accessor whatever its component type, stride and sparse changes. Normalized integers become −1 … 1 or
/// 0 … 1, other integers the numbers that they are (exact up to 24 bits). Throws InputError where it has another number
/// of components than `least` … `most`; `where` is what names it.
Elements elements(const Document& document, std::size_t accessor, std::size_t least, std::size_t most,
                  const Source& where);

/// The whole numbers ≥ 0 of an accessor of unsigned integers.
std::vector<std::uint32_t> whole_numbers(const Document& document, std::size_t accessor, const Source& where);

}  // namespace sturm::gltf
