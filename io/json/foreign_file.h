#pragma once
#include <string>
#include <string_view>

namespace sturm {

/// What a file is that was given for JSON and begins like another kind of file: "a PNG picture", "a table (CSV)"; ""
/// where it may be JSON, or is nothing that people are likely to mix up with it.
std::string other_kind_of_file(std::string_view contents);

}  // namespace sturm
