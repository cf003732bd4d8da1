#pragma once

namespace sturm {

/// Power heuristic with exponent 2 (Veach & Guibas 1995) for a technique against one that has `ratio` times its
/// density.
inline float mis_weight(float ratio) {
  return 1.0f / (1.0f + ratio * ratio);
}

/// The same for the technique of density `a` against one of density `b`.
inline float mis_weight(float a, float b) {
  return mis_weight(b / a);
}

}  // namespace sturm
