#pragma once
#include <filesystem>

#include "io/images/image.h"

namespace sturm {

/// Reads a Portable FloatMap of 1 or 3 channels, as stored, either byte order; row 0 at the top (the file has it at the
/// bottom). Throws InputError for missing, broken and oversized (> 2^28 pixels) files.
Image read_pfm(const std::filesystem::path& path);

}  // namespace sturm
