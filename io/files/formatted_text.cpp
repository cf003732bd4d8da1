#include "io/files/formatted_text.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace sturm {

std::string formatted(const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
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

}  // namespace sturm
