#pragma once
#include <string>
#include <string_view>

namespace sturm {

/// The bytes as a gzip file (RFC 1952), the same for the same bytes. Throws RuntimeFailure if zlib refuses.
std::string gzip(std::string_view bytes);

/// The bytes of a gzip file. Throws RuntimeFailure if it is none or is cut off.
std::string gunzip(std::string_view file);

}  // namespace sturm
