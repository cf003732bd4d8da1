#include "compare/findings/measured.h"

#include <cmath>

#include "compare/statistics/test_family.h"

namespace sturm {

Number quotient(const Number& a, const Number& b) {
  return a && b && *b > 0.0 ? Number(*a / *b) : std::nullopt;
}

Number degrees_of(const Number& replicates) {
  return replicates && *replicates > 1.0 ? Number(*replicates - 1.0) : std::nullopt;
}

void mark_by_z(std::span<Measurement> rows, int numbers) {
  TestFamily family(case_family_level);
  for (const Measurement& row : rows)
    for (int i = 0; row.z && i < numbers; ++i) family.add(row.subject, *row.z);
  const double threshold = family.two_sided_threshold();
  for (Measurement& row : rows)
    if (row.listed_as == CaseStatus::Measured && row.z)
      row.listed_as = std::abs(*row.z) > threshold ? CaseStatus::Differs : CaseStatus::Agrees;
}

}  // namespace sturm
