#pragma once
#include <filesystem>

namespace sturm {

/// Throws std::runtime_error where an attribute in the headers of an EXR file claims more bytes than the file has, or
/// other ones than its type: OpenEXR would allocate them before it reads them, or go on at another place. What is
/// broken in another way is left to OpenEXR.
void require_honest_attributes(const std::filesystem::path& path);

}  // namespace sturm
