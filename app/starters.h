#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sturm {

/// Name and text of every file of configs/starters, compiled in.
const std::vector<std::pair<std::string_view, std::string_view>>& embedded_starters();

/// What `sturm init` can start: each kind has its document and its explanation there.
std::vector<std::string> starter_kinds();

}  // namespace sturm
