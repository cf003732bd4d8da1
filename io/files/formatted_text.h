#pragma once
#include <cstddef>
#include <string>

namespace sturm {

/// Text as printf makes it, up to 1023 bytes.
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// `text` with spaces behind it up to `width` characters on a screen; printf would count the bytes of UTF-8.
std::string padded(const std::string& text, std::size_t width);

/// A number as plain ASCII text with `significant` digits.
std::string plain_number(double value, int significant = 6);

}  // namespace sturm
