#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace sturm {

/// One number that sums up a report, over all the cases that it speaks of.
struct Statistic {
  std::optional<double>
      value;  ///< none when there is no case, or when any case has no number: missing evidence is not evidence
  std::optional<double> uncertainty;  ///< one standard error, of the worst case
  std::uint64_t cases = 0;
  std::string worst_case;                        ///< the case that `value` comes from, or the one without a number
  std::optional<double> degrees = std::nullopt;  ///< of freedom, of `uncertainty`; none: it is as good as known
};

using Statistics = std::map<std::string, Statistic>;  ///< by name

}  // namespace sturm
