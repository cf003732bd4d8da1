#pragma once
#include <cstdint>
#include <string>

#include "lensmodel/words.h"

namespace sturm {

/// What became of a ray at a lens.
enum class LensStatus : std::uint8_t {
  ok,           ///< it came through
  missed_lens,  ///< beyond the rim or past the surface, or it meets the surface from the wrong side or on another sheet
  total_internal_reflection,  ///< it cannot leave the glass
  no_convergence              ///< the search for the point on the surface did not end
};

inline constexpr Words<LensStatus, 4> lens_status_words{
    {{LensStatus::ok, "ok"},
     {LensStatus::missed_lens, "missed_lens"},
     {LensStatus::total_internal_reflection, "total_internal_reflection"},
     {LensStatus::no_convergence, "no_convergence"}}};  ///< in documents

/// The word for it in documents.
inline std::string name_of(LensStatus status) {
  return std::string(lens_status_words.word_of(status));
}

}  // namespace sturm
