#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"

namespace sturm {

/// Which way a number is good.
enum class Better { Unknown, Less, More, Nearer };

/// What became of a case in the report's table of cases, in reading order.
enum class CaseStatus { Failed, NoResult, Differs, Agrees, Measured };

/// One number that a run has found, with all that is needed to judge it. Gates, comparisons of runs and the table of
/// cases are queries on one list of these.
struct Measurement {
  std::string section;     ///< of the report, as in report.json
  std::string subject{};   ///< the case: id of an ellipse, spot, picture, view of a lens, …
  std::string model{};     ///< ray model, kind of prediction or method; "" if it is of none
  std::string quantity{};  ///< plain text with its unit

  Number value{};           ///< none: there is no number where one should be
  Number standard_error{};  ///< none: the report states none
  Number degrees{};         ///< of freedom of the standard error; none: as good as known
  Number z{};               ///< deviation from what is expected, as a normal deviate
  /// How far noise or rounding alone may take the number from what it stands for; where no standard error is known.
  Number bound{};
  Better better = Better::Unknown;
  Number target{};          ///< of Better::Nearer: what the number should be
  bool may_vanish = false;  ///< noise or a better result alone may leave a report without the number

  std::uint64_t cases = 1;   ///< that the number sums up
  std::string worst_case{};  ///< the one that it comes from; "" is `subject`

  std::string statistic{};                ///< its name for gates, if it is a statistic by itself
  std::string run_name{};                 ///< its name where runs are compared; "" is left out there
  std::optional<CaseStatus> listed_as{};  ///< its status as a row of the table of cases; none is no row
};

using Measurements = std::vector<Measurement>;

}  // namespace sturm
