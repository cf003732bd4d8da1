#include "compare/findings/gate_statistics.h"

#include "compare/findings/sections.h"

namespace sturm {

Statistics statistics_of(const Json& report) {
  const Measurements measurements = measurements_of(report);
  Statistics out;
  for (const FindingSection& section : finding_sections()) add_statistics(section.rules, measurements, out);
  add_statistics_by_themselves(measurements, out);
  return out;
}

}  // namespace sturm
