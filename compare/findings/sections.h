#pragma once
#include <span>

#include "compare/findings/measurement.h"
#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// A section of the report, as far as its numbers go.
struct FindingSection {
  const char* name;                                        ///< of what it finds
  void (*measure)(const Json& report, Measurements& out);  ///< lists its numbers; whatever is missing is none
  std::span<const StatisticRule> rules;                    ///< the statistics that gates may ask for
  bool bulky = false;                                      ///< left out of a baseline
};

/// All sections, in the order in which a run fills them. A further section is a further line there.
std::span<const FindingSection> finding_sections();

/// The numbers of a report ("sturm.report/1").
Measurements measurements_of(const Json& report, std::span<const FindingSection> sections = finding_sections());

/// What a gate's statistic is about; see StatisticSubject.
StatisticSubject subject_of(std::string_view statistic, const Measurements& measurements,
                            std::span<const FindingSection> sections = finding_sections());

}  // namespace sturm
