#pragma once
#include "lensmodel/lens_status.h"

namespace sturm {

/// As the formats write it.
inline const char* word_for(LensStatus status) {
  switch (status) {
    case LensStatus::ok:
      return "ok";
    case LensStatus::missed_lens:
      return "missed_lens";
    case LensStatus::total_internal_reflection:
      return "total_internal_reflection";
    default:
      return "no_convergence";
  }
}

}  // namespace sturm
