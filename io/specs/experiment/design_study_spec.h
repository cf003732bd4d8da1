#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/prescription_table.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

/// One of several lens designs.
struct StudyDesign {
  std::string id, note;
  Json document;        ///< validated sturm.spectacles/1
  std::string file;     ///< that it stands in, for messages and relative paths
  SpectaclesSpec made;  ///< for its own prescription
};

/// Those who try all designs.
struct WearerPopulation {
  std::vector<TabledPrescription> wearers;
  std::optional<double> amplitude_D;  ///< of all of them; none: as their ages have it
};

/// How several lens designs differ, and what a population sees through each.
struct DesignStudySpec {
  std::vector<StudyDesign> designs;                  ///< ids are unique; the first is what the others are compared with
  std::vector<double> distances_m;                   ///< of targets, > 0, ∞ allowed
  double pupil_diameter_m = 0.0, amplitude_D = 0.0;  ///< of the eyes whose fields of ellipses are drawn
  double clear_D = 0.0;                              ///< defocus up to which vision counts as clear
  double reach_deg = 0.0, step_deg = 0.0;            ///< gazes of the wearers: a grid within a circle
  std::optional<double> range_D;                     ///< end of the scale of all maps; none: what they need
  double rotation_center_m = mean_rotation_center_m;  ///< behind the pupil
  std::optional<WearerPopulation> population;
  std::vector<std::string> input_files;  ///< absolute paths of lens files and of the table
};

/// Reads a validated "design_study" section with its defaults spelt out. Throws InputError.
DesignStudySpec read_design_study(const Json& value, const Source& where);

}  // namespace sturm
