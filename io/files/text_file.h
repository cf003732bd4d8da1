#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace sturm {

/// The bytes of a file; none where it cannot be read.
std::optional<std::string> file_contents(const std::filesystem::path& file);

}  // namespace sturm
