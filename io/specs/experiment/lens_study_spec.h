#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/specs/eye_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

/// One eye and its lens.
struct StudyLens {
  std::string id, note;
  Prescription prescription;
  Spectacles lens;
};

/// A row of horizontal gazes through one lens: the wide field of [Kakimoto2010] Fig. 14.
struct WideGaze {
  std::size_t lens = 0;              ///< index into the study's lenses
  std::vector<double> azimuths_deg;  ///< to the wearer's right
  double distance_m = 0.0;           ///< > 0, ∞ allowed
  double pupil_diameter_m = 0.0;
};

/// How far tracing methods are from real rays: every lens × gaze × distance × pupil.
struct LensStudySpec {
  std::vector<StudyLens> lenses;                      ///< ids are unique
  double rotation_center_m = mean_rotation_center_m;  ///< behind the pupil
  std::vector<double> eccentricities_deg;             ///< of the gaze from the lens's axis, ascending
  std::vector<double>
      directions_deg;  ///< of the gaze about the axis as the wearer sees it: 0 right, 90 up. Eccentricity 0 has none
  std::vector<double> distances_m;                  ///< > 0, ∞ allowed
  std::vector<double> pupil_diameters_m;            ///< > 0, ascending
  double order_small_m = 0.0, order_large_m = 0.0;  ///< the two of them between which orders are fitted
  Accommodation accommodation;                      ///< relaxed or fixed: the same for all methods
  QuadratureSpec quadrature;                        ///< of the pupil, for the real rays
  std::optional<WideGaze> wide_gaze;
  std::vector<std::string> input_files;  ///< absolute paths of lens files
};

/// Reads a validated "lens_study" section with its defaults spelt out. Throws InputError.
LensStudySpec read_lens_study(const Json& value, const Source& where);

}  // namespace sturm
