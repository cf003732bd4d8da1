#pragma once
#include <cstdlib>

namespace sturm::testing {

/// RapidCheck draws a new seed for every run unless told otherwise; tests here repeat exactly. Override with RC_PARAMS
/// in the environment.
inline const bool rapidcheck_seed_is_fixed = setenv("RC_PARAMS", "seed=8429", 0) == 0;

}  // namespace sturm::testing
