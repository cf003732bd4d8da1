#include "io/files/formatted_text.h"

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

std::string plain_number(double value, int significant) {
  return formatted("%.*g", significant, value);
}

}  // namespace sturm
