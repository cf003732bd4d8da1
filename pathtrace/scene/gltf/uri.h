#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/json/json.h"

namespace sturm::gltf {

/// "%41" → "A"; what is no pair of hexadecimal digits stays as it is.
std::string percent_decoded(std::string_view text);

/// The bytes of a `data:` URI [RFC 2397], base64 or percent-encoded; none where the text is no such URI. Throws
/// InputError where it is broken.
std::optional<std::string> data_of_uri(std::string_view uri, const Source& where);

/// The file that a relative URI names, beside `naming_file`: its name decoded [RFC 3986], or as it is written where
/// only such a file exists. Throws InputError where there is none, and for URIs of the net.
std::filesystem::path file_of_uri(const std::string& uri, const std::filesystem::path& naming_file,
                                  const Source& where);

}  // namespace sturm::gltf
