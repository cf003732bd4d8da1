#include "experiments/stress/suite.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace sturm::stress {

namespace {

constexpr std::uint64_t cases_per_block = 4096;

void add(CheckSummary& to, const Outcome& o, std::uint64_t index) {
  if (!o.ran) {
    ++to.skipped[static_cast<std::size_t>(o.skip)];
    return;
  }
  ++to.run;
  to.over += o.ratio > 1.0;
  if (o.ratio > to.worst_ratio) to.worst_ratio = o.ratio, to.worst_case = index;
  if (o.relative > to.worst_relative) to.worst_relative = o.relative, to.worst_relative_case = index;
}

void add(CheckSummary& to, const CheckSummary& later) {
  to.run += later.run;
  to.over += later.over;
  for (std::size_t i = 0; i < skips.size(); ++i) to.skipped[i] += later.skipped[i];
  if (later.worst_ratio > to.worst_ratio) to.worst_ratio = later.worst_ratio, to.worst_case = later.worst_case;
  if (later.worst_relative > to.worst_relative)
    to.worst_relative = later.worst_relative, to.worst_relative_case = later.worst_relative_case;
}

}  // namespace

void SuiteSummary::add(std::uint64_t index, const CaseRun& run) {
  for (std::size_t i = 0; i < check_count; ++i) stress::add(checks[i], run.outcomes.all()[i], index);
  const bool wrong = !run.outcomes.passed();
  FamilySummary& family = families[static_cast<std::size_t>(run.numbers.family)];
  ++family.cases;
  family.failed += wrong;
  if (!run.eye)
    ++family.refused;
  else
    ++family.statuses[static_cast<std::size_t>(run.conoid ? run.conoid->status : LensStatus::ok)];
  failed += wrong;
  if (wrong && first_failed.size() < listed_failures) first_failed.push_back(index);
  published_tried += run.published_tried;
  published_failed += run.published_failed;
}

void SuiteSummary::add(const SuiteSummary& later) {
  for (std::size_t i = 0; i < check_count; ++i) stress::add(checks[i], later.checks[i]);
  for (std::size_t i = 0; i < families.size(); ++i) {
    families[i].cases += later.families[i].cases;
    families[i].refused += later.families[i].refused;
    families[i].failed += later.families[i].failed;
    for (std::size_t s = 0; s < families[i].statuses.size(); ++s)
      families[i].statuses[s] += later.families[i].statuses[s];
  }
  failed += later.failed;
  for (const std::uint64_t index : later.first_failed)
    if (first_failed.size() < listed_failures) first_failed.push_back(index);
  published_tried += later.published_tried;
  published_failed += later.published_failed;
}

SuiteSummary run_suite(const SuiteOptions& options, const std::function<void(double)>& progress,
                       const ConoidTracer& tracer) {
  const std::uint64_t blocks = (options.cases + cases_per_block - 1) / cases_per_block;
  const FreeFormLenses free_forms;
  std::vector<SuiteSummary> parts(blocks);
  std::atomic<std::uint64_t> done = 0;
  tbb::parallel_for(std::uint64_t{0}, blocks, [&](std::uint64_t b) {
    for (std::uint64_t i = b * cases_per_block; i < std::min(options.cases, (b + 1) * cases_per_block); ++i)
      parts[b].add(i, run_case(options.seed, i, free_forms, tracer));
    progress(static_cast<double>(++done) / static_cast<double>(blocks));
  });
  SuiteSummary total;
  total.options = options;
  for (const SuiteSummary& part : parts) total.add(part);
  return total;
}

}  // namespace sturm::stress
