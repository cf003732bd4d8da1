#include "io/files/formatted_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace sturm {

namespace {

template <class Number>
std::string shortest(Number value) {
  if (std::isnan(value)) return "nan";  // whatever its sign is
  std::array<char, 64> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

std::string formatted(const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  // One byte more than the text has: the zero behind a string may be written again.
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

std::string padded(const std::string& text, std::size_t width) {
  const auto characters = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  return text + std::string(characters < width ? width - characters : 0, ' ');
}

std::string plain_number(double value, int significant) {
  return formatted("%.*g", significant, value);
}

std::string exact_number(double value) {
  return shortest(value);
}

std::string exact_number(float value) {
  return shortest(value);
}

}  // namespace sturm
