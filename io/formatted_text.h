#pragma once
#include <string>

namespace sturm {

/// Text as printf makes it, up to 1023 bytes.
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace sturm
