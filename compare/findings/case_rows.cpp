#include "compare/findings/case_rows.h"

#include <algorithm>

#include "compare/gates/gate_result.h"

namespace sturm {

namespace {

/// Whether the failed gate `gate`, which is about `subject`, names this row as the one that decided.
bool decided(const GateResult& gate, const StatisticSubject& subject, const Measurement& row) {
  if (row.section != subject.section || (!subject.model.empty() && row.model != subject.model)) return false;
  const std::string& worst = gate.worst_case;
  const bool part_of_it = worst.starts_with(row.subject + ",") || worst.starts_with(row.subject + "|");
  return worst == row.subject || part_of_it || gate.statistic == row.statistic;
}

}  // namespace

Measurements case_rows(const Json& report, std::span<const FindingSection> sections) {
  const Measurements all = measurements_of(report, sections);
  Measurements rows;
  std::copy_if(all.begin(), all.end(), std::back_inserter(rows), [](const Measurement& m) { return m.listed_as; });
  for (const GateResult& gate : read_gate_results(report)) {
    if (gate.has_passed()) continue;
    const StatisticSubject subject = subject_of(gate.statistic, all, sections);
    for (Measurement& row : rows)
      if (decided(gate, subject, row)) row.listed_as = CaseStatus::Failed;
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Measurement& a, const Measurement& b) {
    return a.listed_as != b.listed_as ? *a.listed_as < *b.listed_as : a.z.value_or(0.0) > b.z.value_or(0.0);
  });
  return rows;
}

}  // namespace sturm
