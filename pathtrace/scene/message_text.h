#pragma once
#include <string>
#include <string_view>

namespace sturm {

// Numbers and texts of model files as messages show them.

/// The shortest text that is read back as the same number.
std::string shortest(float value);
std::string shortest(double value);

/// A text of a file in quotes, cut to at most 60 characters; bytes that are no UTF-8 and control characters become "?".
std::string in_quotes(std::string_view text);

}  // namespace sturm
