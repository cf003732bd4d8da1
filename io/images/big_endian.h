#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sturm {

/// The whole number in `count` bytes from `at` on, the most significant one first. The bytes must be there.
inline std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

}  // namespace sturm
