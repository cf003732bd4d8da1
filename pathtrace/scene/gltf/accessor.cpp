#include "pathtrace/scene/gltf/accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "io/files/error.h"
#include "pathtrace/scene/gltf/component_types.h"
#include "pathtrace/scene/gltf/members.h"

namespace sturm::gltf {

namespace {

/// Where elements lie: `stride` bytes from one to the next.
struct Places {
  const unsigned char* first;
  std::size_t stride;
};

template <class Stored>
Stored stored_at(const unsigned char* place) {
  Stored value;  // not aligned where writers are careless
  std::memcpy(&value, place, sizeof value);
  return value;
}

/// [glTF 2.0 specification, section 3.11]
template <class Stored>
float number_of(Stored value, bool normalized) {
  if constexpr (std::is_integral_v<Stored>) {
    if (normalized)
      return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<Stored>::max()), -1.0f);
  }
  return static_cast<float>(value);
}

template <class Stored>
void copy_as(const Places& from, std::size_t count, std::size_t components, bool normalized, float* to) {
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < components; ++c)
      *to++ = number_of(stored_at<Stored>(from.first + i * from.stride + c * sizeof(Stored)), normalized);
}

void copy_elements(const Places& from, std::uint64_t component_type, std::size_t count, std::size_t components,
                   bool normalized, float* to) {
  switch (component_type) {
    case 5120:
      return copy_as<std::int8_t>(from, count, components, normalized, to);
    case 5121:
      return copy_as<std::uint8_t>(from, count, components, normalized, to);
    case 5122:
      return copy_as<std::int16_t>(from, count, components, normalized, to);
    case 5123:
      return copy_as<std::uint16_t>(from, count, components, normalized, to);
    case 5125:
      return copy_as<std::uint32_t>(from, count, components, normalized, to);
    default:
      if (from.stride == components * sizeof(float) && count > 0) {
        std::memcpy(to, from.first, count * from.stride);
        return;
      }
      return copy_as<float>(from, count, components, false, to);
  }
}

Places places(const Document& document, const Json& parent, const Source& where, std::size_t element) {
  const std::size_t view = number(parent, "bufferView", where);
  const std::size_t stride = number(document.json()["bufferViews"][view], "byteStride", where, 0);
  return {document.view(view).data() + number(parent, "byteOffset", where, 0), stride ? stride : element};
}

std::vector<std::uint32_t> whole_numbers_at(const Places& from, std::uint64_t component_type, std::size_t count,
                                            const Source& where) {
  std::vector<std::uint32_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned char* place = from.first + i * from.stride;
    switch (component_type) {
      case 5121:
        numbers[i] = *place;
        break;
      case 5123:
        numbers[i] = stored_at<std::uint16_t>(place);
        break;
      case 5125:
        numbers[i] = stored_at<std::uint32_t>(place);
        break;
      default:
        throw InputError(where.file, where.pointer + "/componentType", std::to_string(component_type),
                         "an unsigned integer type (5121, 5123 or 5125)");
    }
  }
  return numbers;
}

struct Layout {
  const Json& accessor;
  Source place;
  std::size_t count, components;
  std::uint64_t component_type;

  Layout(const Document& document, std::size_t index)
      : accessor(document.json()["accessors"][index]),
        place(document.root() / "accessors" / index),
        count(number(accessor, "count", place)),
        components(*components_of_type(text(accessor, "type", place, ""))),
        component_type(number(accessor, "componentType", place)) {}

  std::size_t element() const { return components * *bytes_of_component(component_type); }
};

/// Elements that a sparse accessor replaces, by number.
std::vector<std::uint32_t> changed_elements(const Document& document, const Layout& layout) {
  const Json& sparse = layout.accessor["sparse"];
  const Source where = layout.place / "sparse" / "indices";
  const Json& indices = sparse["indices"];
  const std::uint64_t type = number(indices, "componentType", where);
  const auto numbers = whole_numbers_at(places(document, indices, where, *bytes_of_component(type)), type,
                                        number(sparse, "count", where), where);
  for (const std::uint32_t changed : numbers)
    if (changed >= layout.count)
      throw InputError(where.file, where.pointer, std::to_string(changed),
                       "the number of an element, less than " + std::to_string(layout.count));
  return numbers;
}

}  // namespace

Elements elements(const Document& document, std::size_t accessor, std::size_t least, std::size_t most,
                  const Source& where) {
  const Layout layout(document, accessor);
  if (layout.components < least || layout.components > most)
    throw InputError(
        where.file, where.pointer, text(layout.accessor, "type", layout.place, ""),
        "an accessor with " +
            (least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most)) +
            " components");
  const bool normalized = flag(layout.accessor, "normalized", layout.place, false);
  Elements result{layout.components, std::vector<float>(layout.count * layout.components, 0.0f)};
  if (layout.accessor.contains("bufferView"))
    copy_elements(places(document, layout.accessor, layout.place, layout.element()), layout.component_type,
                  layout.count, layout.components, normalized, result.values.data());
  if (!layout.accessor.contains("sparse")) return result;
  const std::vector<std::uint32_t> changed = changed_elements(document, layout);
  std::vector<float> values(changed.size() * layout.components);
  copy_elements(
      places(document, layout.accessor["sparse"]["values"], layout.place / "sparse" / "values", layout.element()),
      layout.component_type, changed.size(), layout.components, normalized, values.data());
  for (std::size_t i = 0; i < changed.size(); ++i)
    std::copy_n(&values[i * layout.components], layout.components, &result.values[changed[i] * layout.components]);
  return result;
}

std::vector<std::uint32_t> whole_numbers(const Document& document, std::size_t accessor, const Source& where) {
  const Layout layout(document, accessor);
  if (layout.components != 1) where.fail(layout.accessor["type"], "an accessor of type SCALAR");
  std::vector<std::uint32_t> numbers(layout.count, 0);
  if (layout.accessor.contains("bufferView"))
    numbers = whole_numbers_at(places(document, layout.accessor, layout.place, layout.element()), layout.component_type,
                               layout.count, layout.place);
  if (!layout.accessor.contains("sparse")) return numbers;
  const std::vector<std::uint32_t> changed = changed_elements(document, layout);
  const auto values = whole_numbers_at(
      places(document, layout.accessor["sparse"]["values"], layout.place / "sparse" / "values", layout.element()),
      layout.component_type, changed.size(), layout.place);
  for (std::size_t i = 0; i < changed.size(); ++i) numbers[changed[i]] = values[i];
  return numbers;
}

}  // namespace sturm::gltf
