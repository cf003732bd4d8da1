#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sturm {

/// How a picture made without some work differs from one made with it.
enum class PlanClaim {
  same_bits,      ///< not at all
  rounding,       ///< by rounding, of camera rays or of pixels; a ray that grazes an edge may fall on its other side
  bounded,        ///< by no more than the bound that the finding states
  same_mean,      ///< its noise is another
  noise_repeated  ///< a second picture has the first one's noise in place of its own
};

inline const char* name_of(PlanClaim claim) {
  switch (claim) {
    case PlanClaim::same_bits:
      return "same bits";
    case PlanClaim::rounding:
      return "rounding";
    case PlanClaim::bounded:
      return "bounded";
    case PlanClaim::same_mean:
      return "same mean";
    default:
      return "noise repeated";
  }
}

/// One thing that a view may do without.
struct PlanItem {
  std::string name;                              ///< of its switch, see io/specs/skip_spec.h
  std::string view;                              ///< "left" or "right" of a stereo pair, else ""
  bool needless;                                 ///< the view does not need it
  bool switched_on;                              ///< the switch lets it be left out
  PlanClaim claim;                               ///< what leaving it out does to the picture
  std::string finding;                           ///< why it is needed or not, with the numbers that decide it
  std::map<std::string, std::uint64_t> saved{};  ///< after rendering: how often it was left out, by unit

  bool left_out() const { return needless && switched_on; }
};

/// What is left out of a view and why. Further kinds of saved work are further items.
using WorkPlan = std::vector<PlanItem>;

}  // namespace sturm
