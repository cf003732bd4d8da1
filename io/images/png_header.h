#pragma once
#include <filesystem>
#include <optional>

namespace sturm {

/// Bits of a channel of a PNG file, from its first chunk; none for other files.
std::optional<int> png_bit_depth(const std::filesystem::path& path);

}  // namespace sturm
