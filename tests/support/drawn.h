#pragma once
#include <rapidcheck.h>

namespace sturm::testing {

/// A number that a property test draws: a multiple of `unit` from low to high.
inline double drawn(int low, int high, double unit) {
  return *rc::gen::inRange(low, high + 1) * unit;
}

}  // namespace sturm::testing
