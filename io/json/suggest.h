#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// Edit distance (insertions, deletions, substitutions, swaps of neighbours), case ignored.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, if it is near enough to be what was meant: 2 edits (1 for words of up to 4
/// letters), or the same name with another unit ("distance_mm" for "distance_m").
std::optional<std::string> suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// ` (did you mean "…"?)` for the suggestion, "" if there is none.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// `one of "a", "b"`; `"a"` for a single candidate; cut after `limit` of them.
std::string one_of(const std::vector<std::string>& candidates, std::size_t limit = 24);

}  // namespace sturm
