#include "io/json/suggest.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace sturm {

namespace {

/// The units that names at the edges of the program end in.
bool has_unit(std::string_view name) {
  static constexpr std::array<std::string_view, 6> units = {"_D", "_m", "_mm", "_deg", "_rad", "_years"};
  return std::any_of(units.begin(), units.end(), [&](std::string_view unit) { return name.ends_with(unit); });
}

std::string_view without_unit(std::string_view name) {
  return has_unit(name) ? name.substr(0, name.rfind('_')) : name;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  // Rows i − 2, i − 1 and i of the table of distances between prefixes (optimal string alignment).
  std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[b.size()];
}

std::optional<std::string> suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  int least = word.size() <= 4 ? 2 : 3;  // one more than is near enough
  if (word.size() > 64) return best;     // no key is that long
  for (const std::string& candidate : candidates)
    if (const int distance = edit_distance(word, candidate); distance < least) {
      least = distance;
      best = candidate;
    }
  if (best) return best;
  for (const std::string& candidate : candidates)
    if (has_unit(candidate) && without_unit(candidate) == without_unit(word)) return candidate;
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto nearest = suggestion(word, candidates);
  return nearest ? " (did you mean \"" + *nearest + "\"?)" : "";
}

std::string one_of(const std::vector<std::string>& candidates, std::size_t limit) {
  if (candidates.empty()) return "nothing";
  std::string text = candidates.size() == 1 ? "" : "one of ";
  for (std::size_t i = 0; i < std::min(candidates.size(), limit); ++i)
    text += (i ? ", \"" : "\"") + candidates[i] + "\"";
  return candidates.size() > limit ? text + ", …" : text;
}

}  // namespace sturm
