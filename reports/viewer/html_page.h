#pragma once
#include <string>
#include <string_view>

#include "reports/markup/html.h"

namespace sturm {

/// A whole page in the style of the reports, with the script that sorts their tables. `title` is plain text.
std::string html_page(std::string_view title, const Html& body);

}  // namespace sturm
