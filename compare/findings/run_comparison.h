#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// Something that two runs do not have in common.
struct RunChange {
  enum class Kind {
    BeyondUncertainty,   ///< both have a standard error or a bound of noise, and they differ by more than that explains
    WithoutUncertainty,  ///< the numbers differ, and nothing says what that means
    Verdict,             ///< a gate passed in one run only
    New,                 ///< only in the later run
    Missing              ///< only in the earlier run: evidence that is gone, unless the number may vanish by chance
  };
  enum class Direction { Neither, Better, Worse };

  std::string name;
  Kind kind;
  Direction direction = Direction::Neither;
  std::optional<double> before, after;
  std::optional<double> standard_error;  ///< of the difference; none also where a bound was exceeded
  std::optional<double> z;               ///< of the difference, as a normal deviate

  /// Whether a gate has to reject the later run because of it: it is worse, and more than a number of unknown
  /// uncertainty.
  bool is_regression() const { return direction == Direction::Worse && kind != Kind::WithoutUncertainty; }
};

struct RunComparison {
  double level = 0.0;        ///< chance of any false alarm in the whole comparison
  std::size_t tests = 0;     ///< numbers with a standard error in both runs
  double threshold_z = 0.0;  ///< above which abs(z) is beyond uncertainty
  std::size_t numbers = 0;   ///< that both runs have
  std::size_t bounded = 0;   ///< of them without a standard error, but with a bound of noise or rounding in both runs
  std::vector<RunChange> changes;  ///< regressions first, then by kind, then by abs(z)

  std::size_t regressions() const;
};

/// Compares two reports of the same experiment ("sturm.report/1"). Numbers with standard errors in both are compared by
/// Welch's t of the difference (degrees of freedom by Satterthwaite from the replicates), at the family-wise level
/// `level` over all of them; equal numbers of the same run count as equal. Numbers with a bound of noise or rounding in
/// both differ where they are further apart than both bounds together. Of a number that is beyond uncertainty it is
/// known whether it is worse where there is something that it should equal, or a direction. A gate that fails where it
/// passed, and whatever is missing, is worse. Throws std::domain_error unless 0 < level < 1.
RunComparison compare_runs(const Json& before, const Json& after, double level);

/// The comparison as "sturm.run_comparison/1"; `file_before` and `file_after` are what the reports were read from.
Json run_comparison_json(const RunComparison& comparison, const Json& before, const std::string& file_before,
                         const Json& after, const std::string& file_after);

/// One sentence: how much was compared, and what came out.
std::string sentence_of(const RunComparison& comparison);

}  // namespace sturm
