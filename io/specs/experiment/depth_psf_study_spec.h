#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// Point spreads by rays against those by waves, of an eye without aberration: every pupil × defocus, in one wavelength
/// and in white light.
struct SpreadMapSpec {
  std::vector<double> pupil_diameters_m;  ///< > 0
  std::vector<double> defocus_D;
  double wavelength_nm = 0.0;
  double step_nm = 0.0;      ///< between the wavelengths of white light
  double cell_arcmin = 0.0;  ///< side of the cells whose energies are compared
};

/// What measured eyes have beyond second order.
struct MeasuredEyes {
  std::string id, title;
  double pupil_diameter_m = 0.0;                       ///< that they were measured over
  std::vector<std::vector<double>> coefficients_um{};  ///< OSA/ANSI, normalised, of each eye
};

/// A striped surface that leans from far to near, seen by an eye without aberration, with its planes at several
/// spacings.
struct BandingSpec {
  double nearest_m = 0.0, farthest_m = 0.0;
  double reach_px_per_D = 0.0;        ///< the pupil's radius over the size of a pixel
  std::vector<double> spacings_px{};  ///< of the blur's radius, from plane to plane
};

/// A validated section "depth_psf_study".
struct DepthPsfStudySpec {
  std::optional<SpreadMapSpec> map;
  std::vector<MeasuredEyes> eyes;  ///< ids are unique
  std::optional<BandingSpec> banding;
  std::vector<std::string> input_files;  ///< absolute paths
};

/// Reads a resolved section "depth_psf_study". Throws InputError.
DepthPsfStudySpec read_depth_psf_study(const Json& value, const Source& where);

}  // namespace sturm
