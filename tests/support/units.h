#pragma once
#include <numbers>

namespace sturm::testing {

// So that a test says 12 * mm where the code under test takes metres.
inline constexpr double mm = 1e-3, um = 1e-6, pi = std::numbers::pi, degree = pi / 180.0;

}  // namespace sturm::testing
