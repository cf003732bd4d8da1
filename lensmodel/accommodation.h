#pragma once
#include <optional>
#include <variant>

namespace sturm {

/// The eye's lens at rest: A = 0.
struct RelaxedAccommodation {};

/// A given power, however it was stated; docs/theory.md#31-accommodation-modes `fixed`.
struct FixedAccommodation {
  double power_D = 0.0;  ///< A ≥ 0 [D]; 1/focus distance where that was given
  double focus_distance_m =
      0.0;  ///< > 0 where the accommodation was stated as a distance [m] (∞ allowed); 0 where as a power
};

/// The eye chooses A in [0, amplitude] for each target so that the larger semi-axis of the blur ellipse is least.
struct BestAccommodation {
  double amplitude_D = 0.0;  ///< A_max ≥ 0 [D]
};

using Accommodation = std::variant<RelaxedAccommodation, FixedAccommodation, BestAccommodation>;  ///< one of the three

/// The distance [m] that an accommodation was stated as, where it was.
inline std::optional<double> stated_focus_distance_m(const Accommodation& accommodation) {
  const auto* fixed = std::get_if<FixedAccommodation>(&accommodation);
  return fixed && fixed->focus_distance_m > 0.0 ? std::optional(fixed->focus_distance_m) : std::nullopt;
}

/// Mean amplitude of accommodation [D] at an age in years: Hofstetter's 18.5 − 0.3·age, never below 0.
double hofstetter_amplitude(double age_years);

}  // namespace sturm
