#pragma once
#include <cstdint>

#include "experiments/stress/stress_case.h"

namespace sturm::stress {

/// The case number `index` of the suite with this seed; the same on every machine with the same libm.
CaseNumbers draw_case(std::uint64_t seed, std::uint64_t index, const FreeFormLenses& free_forms);

}  // namespace sturm::stress
