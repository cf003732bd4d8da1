#pragma once
#include <cstdint>

namespace sturm {

/// What became of a ray at a lens.
enum class LensStatus : std::uint8_t {
  ok,
  missed_lens,  ///< beyond the rim or past the surface, or it meets the surface from the wrong side or on another sheet
  total_internal_reflection,  ///< it cannot leave the glass
  no_convergence              ///< the search for the point on the surface did not end
};

}  // namespace sturm
