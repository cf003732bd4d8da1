#pragma once
#include <string>
#include <vector>

namespace sturm {

/// Rows of equally many cells as lines whose cells stand below one another; the last column is not filled up.
std::string text_columns(const std::vector<std::vector<std::string>>& rows);

}  // namespace sturm
