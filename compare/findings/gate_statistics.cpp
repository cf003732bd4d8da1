#include "compare/findings/gate_statistics.h"

namespace sturm {

Statistics statistics_of(const Json& report, std::span<const FindingSection> sections) {
  const Measurements measurements = measurements_of(report, sections);
  Statistics out;
  for (const FindingSection& section : sections) add_statistics(section.rules, measurements, out);
  add_statistics_by_themselves(measurements, out);
  return out;
}

}  // namespace sturm
