#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// What is written to files and standard output: `value` with an indentation of so many blanks for each level (-1: on
/// one line). Strings that came from names of files, or from names within them, need not be UTF-8; their broken bytes
/// become U+FFFD.
std::string json_text(const Json& value, int indent = -1);

}  // namespace sturm
