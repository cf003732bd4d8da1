#pragma once

namespace sturm {

/// Power heuristic with exponent 2 (Veach & Guibas 1995) for the technique of density `a` against one of density `b`.
inline float mis_weight(float a, float b) {
  const float ratio = b / a;
  return 1.0f / (1.0f + ratio * ratio);
}

}  // namespace sturm
