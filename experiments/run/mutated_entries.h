#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// Entries of a section as a step keeps them: under "mutated" each has, by the mutation's id, the entry that a mutated
/// predictor would have brought about in its place. One that a mutation leaves alone has none.

/// The entries that a report has.
Json honest_entries(Json entries);

/// The entries of the report that the mutated predictor would have brought about.
Json mutated_entries(Json entries, const std::string& mutation);

}  // namespace sturm
