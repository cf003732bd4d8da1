#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace sturm {

/// SHA-256 (FIPS 180-4) of bytes, as 64 lower-case hexadecimal digits. Throws RuntimeFailure if OpenSSL refuses.
std::string sha256(std::string_view bytes);

/// The same of a file's contents, read in pieces. Throws InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace sturm
