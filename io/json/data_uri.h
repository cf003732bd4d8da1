#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "io/json/json.h"

namespace sturm {

/// "%41" → "A"; what is no pair of hexadecimal digits stays as it is.
std::string percent_decoded(std::string_view text);

/// The bytes of a `data:` URI [RFC 2397], base64 or percent-encoded; none where the text is no such URI. Throws
/// InputError where it is broken.
std::optional<std::string> data_of_uri(std::string_view uri, const Source& where);

}  // namespace sturm
