#pragma once
#include <filesystem>
#include <string>

namespace sturm {

/// Throws InputError unless `path` is a plain file; the message says what it is instead, and `expected`.
void require_plain_file(const std::filesystem::path& path, const std::string& expected);

/// Whether a file's name ends in `suffix` (".png"), in whatever case.
bool has_suffix(const std::filesystem::path& path, const std::string& suffix);

}  // namespace sturm
