#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// Edit distance (insertions, deletions, substitutions, swaps of neighbours), case ignored.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, if it is near enough (2 edits, 1 for words up to 4 letters) to be what was meant.
std::optional<std::string> suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// `did you mean "…"?` for the nearest candidate, else `one of …` with all of them.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace sturm
