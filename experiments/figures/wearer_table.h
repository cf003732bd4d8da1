#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/prescription_table.h"

namespace sturm {

/// A lens design that wearers try: a single-vision or progressive lens, whose own prescription does not count.
struct TriedDesign {
  std::string name, file;
  Json document;  ///< validated sturm.spectacles/1
};

/// How the wearers of a table look through their lenses.
struct WearerQuestion {
  std::vector<double> distances_m;          ///< of targets, ∞ allowed
  std::optional<double> amplitude_D;        ///< of accommodation; none: as the wearer's age has it, or 0
  double clear_D = 0.25;                    ///< defocus up to which vision counts as clear
  double reach_deg = 30.0, step_deg = 5.0;  ///< gazes: a grid within a circle
  double rotation_center_m = 13.5e-3;
};

/// What a wearer sees of targets at one distance through one lens, over all gazes that reach the lens.
struct WearerRow {
  std::string wearer, lens;
  Prescription prescription;
  std::optional<double> age_years, addition_D;  ///< of the wearer; the addition that a progressive lens was made with
  double amplitude_D = 0.0;                     ///< of accommodation
  double distance_m = 0.0;
  int gazes = 0, lost = 0;     ///< in all, and those that no ray comes through
  double share_blurred = 0.0;  ///< of the gazes that come through: blurred by more than clear_D
  double median_D = 0.0, largest_D = 0.0;
  double largest_azimuth_deg = 0.0, largest_elevation_deg = 0.0;  ///< where it is largest
  std::string not_made;  ///< why the design cannot be made for this wearer, who then has no gazes; empty: it can
};

/// A row for each wearer, design and distance, in this order, the same for any number of threads. Every design is made
/// for the power that the wearer's eye needs at the lens, a progressive one also with the wearer's addition where the
/// table states it. Throws InputError for a design that cannot be made for
/// anybody.
std::vector<WearerRow> wearer_table(const std::vector<TabledPrescription>& wearers,
                                    const std::vector<TriedDesign>& designs, const WearerQuestion& question);

/// The table as CSV.
std::string wearer_csv(const std::vector<WearerRow>& rows, double clear_D);

}  // namespace sturm
