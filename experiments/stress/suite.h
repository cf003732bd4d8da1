#pragma once
#include <array>
#include <functional>
#include <vector>

#include "experiments/stress/case_run.h"

namespace sturm::stress {

struct SuiteOptions {
  std::uint64_t cases = 1000000, seed = 1;
};

/// One check over all cases.
struct CheckSummary {
  std::uint64_t run = 0, over = 0;  ///< over: cases beyond the bound
  std::array<std::uint64_t, stress::skips.size()> skipped{};
  double worst_ratio = 0.0, worst_relative = 0.0;
  std::uint64_t worst_case = 0, worst_relative_case = 0;
};

/// One family over all cases.
struct FamilySummary {
  std::uint64_t cases = 0, refused = 0, failed = 0;
  std::array<std::uint64_t, 4> statuses{};  ///< by LensStatus; the naked eye is ok
};

struct SuiteSummary {
  SuiteOptions options;
  std::array<CheckSummary, check_count> checks{};
  std::array<FamilySummary, stress::families.size()> families{};
  std::vector<std::uint64_t> first_failed;  ///< the first failed cases, at most `listed_failures`
  static constexpr std::size_t listed_failures = 100;
  std::uint64_t failed = 0, published_tried = 0, published_failed = 0;

  void add(std::uint64_t index, const CaseRun& run);
  void add(const SuiteSummary& later);
  bool passed() const { return failed == 0; }
};

/// Runs all cases on the threads that there are. The same result for any number of them: sums over fixed blocks, taken
/// in index order.
SuiteSummary run_suite(const SuiteOptions& options, const std::function<void(double)>& progress,
                       const ConoidTracer& tracer = trace_conoid);

}  // namespace sturm::stress
