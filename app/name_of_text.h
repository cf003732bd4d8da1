#pragma once
#include <filesystem>

namespace sturm {

/// Text does not go into a file that is named as a picture or a page. Throws InputError.
void require_name_of_text(const std::filesystem::path& output);

}  // namespace sturm
