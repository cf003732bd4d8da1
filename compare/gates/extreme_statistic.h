#pragma once
#include <map>
#include <optional>
#include <string>

#include "compare/gates/statistic.h"

namespace sturm {

using Number = std::optional<double>;

/// The largest (or smallest) value over the cases; one case without a number leaves the whole statistic without.
class Extreme {
 public:
  enum class Of { Largest, Smallest };
  explicit Extreme(Of of = Of::Largest) : of_(of) {}

  void add(const Number& value, const std::string& name, const Number& uncertainty = std::nullopt) {
    const bool first = statistic_.cases++ == 0;
    if (spoilt_) return;
    if (!value) {
      statistic_ = {std::nullopt, std::nullopt, statistic_.cases, name};
      spoilt_ = true;
    } else if (first || (of_ == Of::Largest ? *value > *statistic_.value : *value < *statistic_.value)) {
      statistic_ = {value, uncertainty, statistic_.cases, name};
    }
  }

  /// The statistic; its number of cases keeps counting whatever happens.
  const Statistic& result() const { return statistic_; }

 private:
  Of of_;
  bool spoilt_ = false;
  Statistic statistic_;
};

}  // namespace sturm
