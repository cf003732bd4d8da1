#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace sturm {

/// The middle one of some numbers, of an even number of them the mean of the middle two; none of none.
inline std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

}  // namespace sturm
