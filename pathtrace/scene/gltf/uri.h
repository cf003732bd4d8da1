#pragma once
#include <filesystem>
#include <string>

#include "io/json/json.h"

namespace sturm::gltf {

/// The file that a relative URI names, beside `naming_file`: its name decoded [RFC 3986], or as it is written where
/// only such a file exists. Throws InputError where there is none, and for URIs of the net.
std::filesystem::path file_of_uri(const std::string& uri, const std::filesystem::path& naming_file,
                                  const Source& where);

}  // namespace sturm::gltf
