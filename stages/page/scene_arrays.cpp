#include "stages/page/scene_arrays.h"

#include <bit>
#include <nlohmann/json.hpp>

#include "io/json/json_text.h"

namespace sturm {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

namespace {

void fill_up(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
}

}  // namespace

template <class Number>
Json SceneArrays::append(const std::vector<Number>& numbers, int components, const char* type) {
  Json place = {{"at", bytes_.size()},
                {"type", type},
                {"components", components},
                {"count", numbers.size() / static_cast<std::size_t>(components)}};
  bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  fill_up(bytes_, '\0');
  return place;
}

Json SceneArrays::add(const std::vector<float>& numbers, int components) {
  return append(numbers, components, "f32");
}
Json SceneArrays::add(const std::vector<std::uint32_t>& numbers, int components) {
  return append(numbers, components, "u32");
}
Json SceneArrays::add(const std::vector<std::uint16_t>& numbers, int components) {
  return append(numbers, components, "u16");
}
Json SceneArrays::add(const std::vector<std::uint8_t>& numbers, int components) {
  return append(numbers, components, "u8");
}

std::string scene_file(const Json& header, const SceneArrays& arrays) {
  std::string text = json_text(header, -1);
  fill_up(text, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string file = "STURMVS1";
  file.append(reinterpret_cast<const char*>(&length), sizeof length);
  return file + text + arrays.bytes();
}

}  // namespace sturm
