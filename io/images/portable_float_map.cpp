#include "io/images/portable_float_map.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "io/files/readable_text.h"

namespace sturm {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The next word of the header, which notes (# up to the end of the line) may stand before.
std::string_view next_word(std::string_view bytes, std::size_t& at) {
  while (at < bytes.size() && (blanks.find(bytes[at]) != std::string_view::npos || bytes[at] == '#'))
    at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
  const std::size_t start = at;
  at = std::min(bytes.find_first_of(blanks, at), bytes.size());
  return bytes.substr(start, at - start);
}

template <class Number>
Number number(std::string_view word, const char* what) {
  Number value{};
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || end != word.data() + word.size())
    throw std::runtime_error(std::string(what) + " \"" + readable(word, 40) + "\"");
  return value;
}

float float_at(const char* bytes, bool little_endian) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  if (little_endian != (std::endian::native == std::endian::little)) bits = __builtin_bswap32(bits);
  return std::bit_cast<float>(bits);
}

}  // namespace

bool is_portable_float_map(std::string_view bytes) {
  return bytes.size() > 2 && (bytes.starts_with("PF") || bytes.starts_with("Pf")) &&
         blanks.find(bytes[2]) != std::string_view::npos;
}

Image decode_portable_float_map(std::string_view bytes, std::size_t max_pixels, bool as_stored) {
  std::size_t at = 2;
  const std::size_t channels = bytes[1] == 'F' ? 3 : 1;
  const auto width = number<std::size_t>(next_word(bytes, at), "a width"),
             height = number<std::size_t>(next_word(bytes, at), "a height");
  const auto scale = number<double>(next_word(bytes, at), "a scale");
  if (width < 1 || height < 1 || width > max_pixels || height > max_pixels || width * height > max_pixels)
    throw std::runtime_error("an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
  if (scale == 0.0 || !std::isfinite(scale)) throw std::runtime_error("a scale of 0");
  const double factor = as_stored ? 1.0 : std::abs(scale);
  const std::size_t size = width * height * channels * sizeof(float);
  // One blank ends the header; files from Windows may have two.
  at += bytes.substr(at).starts_with("\r\n") && bytes.size() >= at + 2 + size ? 2 : 1;
  if (at > bytes.size() || bytes.size() - at < size) throw std::runtime_error("pixels that break off");
  Image image(static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels));
  const std::size_t row = width * channels;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t i = 0; i < row; ++i) {
      const float value = float_at(bytes.data() + at + ((height - 1 - y) * row + i) * sizeof(float), scale < 0.0);
      image.pixels[y * row + i] = static_cast<float>(value * factor);
    }
  return image;
}

}  // namespace sturm
