#pragma once
#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "compare/psf/encircled_energy.h"
#include "compare/psf/point_spread.h"

namespace sturm {

/// Frequencies [cycles/degree] and directions [deg] that reports give: 3, 6, … 30; 0, 45, 90, 135.
inline constexpr std::array<double, 10> report_frequencies_cpd{3, 6, 9, 12, 15, 18, 21, 24, 27, 30};
inline constexpr std::array<double, 4> report_directions_deg{0, 45, 90, 135};

/// Optical transfer of geometric optics: Σ w exp(−2πi f u·(x − centroid)), u = (cos, sin) of `direction_deg` in the
/// wearer frame, counter-clockwise from the right; the pattern varies along u. What the area of a pixel takes away,
/// sinc along both axes, is divided out.
std::complex<double> optical_transfer(const PointSpread& spread, double frequency_cpd, double direction_deg);

/// |OTF| in [0, 1]. Standard error for N independent rays: variance of w exp(…) in the direction of the OTF's phase,
/// √((½(1 + Re(OTF(2f)·e^(−2iφ))) − |OTF|²)/N).
///
/// None for pictures from half a cycle per pixel on along either axis, where their pixels tell nothing.
std::optional<WithError> modulation_transfer(const PointSpread& spread, double frequency_cpd, double direction_deg);

}  // namespace sturm
