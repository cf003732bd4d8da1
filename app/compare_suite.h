#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands.h"
#include "compare/gates/gate_result.h"

namespace sturm {

/// Two pictures that a suite holds against each other: a folder of their own.
struct SuitePair {
  std::string name;        ///< the folder's
  CompareOptions options;  ///< of the whole suite, with this pair's pictures and bounds
};

/// The pairs of a suite in the order of their names: each folder in `options.suite` with test.EXT and reference.EXT;
/// test_seed.EXT and reference_seed.EXT are the same views with other seeds, bounds.json has bounds of this pair alone
/// ({"ssim_display": 0.95}), which stand before those of the options. Throws InputError for a folder without pairs, for
/// a pair that lacks a picture or has one twice, and for one that nothing judges.
std::vector<SuitePair> suite_pairs(const CompareOptions& options);

/// What the bounds, and with `beyond_noise` the seeds, say of all pairs: one result for each metric with a bound, one
/// for the largest z of each pair with seeds. The false-alarm rate of the latter holds for the whole suite. Throws
/// InputError for pictures that cannot be compared.
std::vector<GateResult> judge_suite(const std::vector<SuitePair>& pairs, bool beyond_noise);

}  // namespace sturm
