#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// `value` as people read it: what fits stays on one line of 120 characters; else its members fill such lines, objects
/// and what is longer on lines of their own, indented by one blank for each level. Ends without a line end. Broken
/// bytes of strings become U+FFFD, as in json_text.
std::string readable_json(const Json& value);

}  // namespace sturm
