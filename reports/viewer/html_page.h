#pragma once
#include <string>
#include <string_view>

namespace sturm {

/// A whole page in the style of the reports, with the script that sorts their tables. `title` is plain text.
std::string html_page(std::string_view title, std::string_view body_html);

}  // namespace sturm
