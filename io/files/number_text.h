#pragma once
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace sturm {

/// Reads the number that [first, last) begins with, as std::from_chars does; returns the end of what was read, `first`
/// if there is none. For libraries that lack it for floating point the text is read by strtod in the C locale: then it
/// must not begin with white space or a plus sign, and hexadecimal numbers would be read.
inline const char* read_number(const char* first, const char* last, double& value) {
#ifdef __cpp_lib_to_chars
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() ? end : first;
#else
  const std::string text(first, last);
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return first + (end - text.c_str());
#endif
}

/// As few digits as read back as the same number, without an exponent.
inline std::string shortest_fixed(double value) {
#ifdef __cpp_lib_to_chars
  char text[400];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr};
#else
  char text[400];
  for (int digits = 0; digits <= 40; ++digits) {
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
#endif
}

}  // namespace sturm
