#pragma once
#include <cstddef>
#include <string>

namespace sturm {

/// Text as printf makes it, of any length.
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// `text` with spaces behind it up to `width` characters on a screen; printf would count the bytes of UTF-8.
std::string padded(const std::string& text, std::size_t width);

/// A number as plain ASCII text with `significant` digits.
std::string plain_number(double value, int significant = 6);

/// The shortest text that reads back as the same number, for messages: 1.0000001 does not become the bound that it
/// passes. "inf", "-inf" and "nan" for what is not finite.
std::string exact_number(double value);
std::string exact_number(float value);

}  // namespace sturm
