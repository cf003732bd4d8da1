#pragma once
#include <optional>
#include <vector>

#include "compare/findings/sections.h"
#include "compare/gates/extreme_statistic.h"

namespace sturm {

/// One eye: the radius of its blur from traced rays, and by the formula: half the pupil's diameter times the defocus.
struct ToyEntry {
  Number defocus_D{}, traced_arcmin{}, expected_arcmin{};

  bool operator==(const ToyEntry&) const = default;
};

/// Section "toy_study" of a report.
struct ToyFindings {
  Number pupil_mm{};
  std::vector<ToyEntry> entries{};

  bool operator==(const ToyFindings&) const = default;
};

/// Both ways; no other code knows the keys.
Json to_json(const ToyFindings& findings);
std::optional<ToyFindings> toy_findings(const Json& report);

/// What gates, comparisons of runs and the table of cases see of it.
void measure_toy_study(const Json& report, Measurements& out);
std::span<const StatisticRule> toy_study_rules();

}  // namespace sturm
