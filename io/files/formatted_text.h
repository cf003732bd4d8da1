#pragma once
#include <string>

namespace sturm {

/// Text as printf makes it, up to 1023 bytes.
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// A number as plain ASCII text with `significant` digits.
std::string plain_number(double value, int significant = 6);

}  // namespace sturm
