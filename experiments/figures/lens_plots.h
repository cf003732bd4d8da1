#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/specs/worn_eye_spec.h"
#include "lensmodel/power_matrix.h"
#include "reports/plots/corridor_plot.h"
#include "reports/plots/plot.h"

namespace sturm {

/// A lens in a figure of several.
struct NamedLens {
  std::string name;
  Spectacles lens;
  PowerMatrix nominal;  ///< that it was made for, or has on its axis
};

/// An eye in a figure of several, with what it wears.
struct NamedEye {
  std::string name;
  WornEye worn;
};

// Figures of several lenses side by side. `range` is the end of the scale; none: what the lenses need.

/// A row of mean powers above a row of cylinders, as worn, each less what the lens was made for; `with_differences`:
/// also those of difference_plot.
Plot power_plot(const std::vector<NamedLens>& lenses, double rotation_center_m, bool with_differences,
                std::optional<double> range);

/// What every further lens has more than the first: a row of mean powers above a row of cylinders. At least two lenses.
Plot difference_plot(const std::vector<NamedLens>& lenses, double rotation_center_m, std::optional<double> range);

/// A column for each lens and a row for each distance [m].
Plot defocus_plot(const std::vector<NamedLens>& lenses, double rotation_center_m,
                  const std::vector<double>& distances_m, double amplitude_D, std::optional<double> range);

/// Progressive lenses along their corridors: where the cylinder of the error is below 0.5 D.
std::vector<CorridorProfile> corridor_profiles(const std::vector<NamedLens>& lenses, double rotation_center_m);

/// A field of blur ellipses for each eye and distance [m]; up to `clear_D` vision counts as clear.
Plot fields_plot(const std::vector<NamedEye>& eyes, const std::vector<double>& distances_m, double clear_D,
                 std::optional<double> range_arcmin);

}  // namespace sturm
