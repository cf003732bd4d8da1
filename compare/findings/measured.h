#pragma once
#include <span>

#include "compare/findings/measurement.h"

namespace sturm {

/// Chance of any false alarm among all rows of one kind in the table of cases together.
inline constexpr double case_family_level = 0.01;

/// a ÷ b; none unless b > 0.
Number quotient(const Number& a, const Number& b);

/// Degrees of freedom of a scatter between `replicates`.
Number degrees_of(const Number& replicates);

/// Rows that have a z are told from noise, two-sided and at the level of all of them together: `Differs` or `Agrees`.
/// Each row's z is the largest of `numbers` that were tested.
void mark_by_z(std::span<Measurement> rows, int numbers = 1);

}  // namespace sturm
