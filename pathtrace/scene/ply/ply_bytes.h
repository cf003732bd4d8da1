#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "io/files/error.h"
#include "pathtrace/scene/ply/ply_header.h"

namespace sturm {

/// The elements of a binary PLY file, one number behind the other.
template <std::endian order>
class PlyBytes {
 public:
  /// `rest`: what follows the header, which had so many bytes.
  PlyBytes(const std::string& file, std::string_view rest, std::size_t header_bytes)
      : file_(file), rest_(rest), end_(header_bytes + rest.size()) {}

  void begin() {}
  void end() const {}

  /// Throws InputError where the file ends, as `skip` does.
  double number(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return take<float>();
      case PlyType::float64:
        break;
    }
    return take<double>();
  }

  void skip(PlyType type, std::size_t count) {
    require(count <= room(type));
    rest_.remove_prefix(count * bytes_of(type));
  }

  std::size_t room(PlyType type) const { return rest_.size() / bytes_of(type); }
  std::string place() const { return file_ + ", byte " + std::to_string(end_ - rest_.size()); }

 private:
  void require(bool is_there) const {
    if (!is_there) throw InputError(file_, "", "an early end", "all elements that the header states");
  }

  template <class T>
  T take() {
    require(rest_.size() >= sizeof(T));
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), rest_.data(), sizeof(T));
    rest_.remove_prefix(sizeof(T));
    if constexpr (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  const std::string& file_;
  std::string_view rest_;
  std::size_t end_;
};

}  // namespace sturm
