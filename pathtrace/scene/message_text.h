#pragma once
#include <string>
#include <string_view>

#include "io/files/formatted_text.h"
#include "io/files/readable_text.h"

namespace sturm {

/// A text of a model file in quotes, as messages show it: readable, and cut to at most 60 characters.
inline std::string in_quotes(std::string_view text) {
  constexpr std::size_t most_characters = 60;
  return "\"" + readable(text, most_characters) + "\"";
}

}  // namespace sturm
