#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "io/json/record.h"

namespace sturm {

/// The point spread by rays against the one by waves, of one pupil and vergence error.
struct SpreadCell {
  std::string light{};  ///< "one_wavelength" or "white"
  Number pupil_mm{}, defocus_D{};
  Number total_variation{};  ///< 0: the same, 1: no light in common
  Number rays_r50_arcmin{};  ///< radius about the chief ray that holds half of the light
  Number waves_r50_arcmin{};

  bool operator==(const SpreadCell&) const = default;
};

/// First quartile, median, third quartile.
using Quartiles = std::array<Number, 3>;

/// By linear interpolation between the ordered values, number k of n at k/(n + 1); without numbers for fewer than two.
Quartiles quartiles_of(std::vector<double> values);

/// What a table of measured eyes has beyond second order.
struct EyesBeyond {
  std::string id{}, title{};
  Number pupil_mm{};
  Count eyes{};
  Quartiles rms_um{};         ///< root mean square of the wavefront beyond second order
  Quartiles defocus_D{};      ///< the defocus with that root mean square
  Quartiles r80_arcmin{};     ///< radius about their centroid that holds 80 % of the rays with second order corrected
  Number share_above_step{};  ///< of the eyes with more of that defocus than the step in which lenses come

  bool operator==(const EyesBeyond&) const = default;
};

inline constexpr double lens_step_D = 0.25;

/// A striped, slanted surface with its planes at one spacing, against the integral over the pupil, in linear light.
struct BandingRow {
  Number spacing_px{};
  std::string weights{};  ///< of a pixel's light: all to the "nearest" plane, or "linear" between two
  Count pupil_parts{}, planes{};
  Number rmse{}, largest_step{};  ///< the step from row to row beyond the true one

  bool operator==(const BandingRow&) const = default;
};

/// Section "depth_psf_study" of a report.
struct DepthPsfFindings {
  std::vector<SpreadCell> map{};
  std::vector<EyesBeyond> eyes{};
  std::vector<BandingRow> banding{};

  bool operator==(const DepthPsfFindings&) const = default;
};

/// Both ways; no other code knows the keys.
Json to_json(const DepthPsfFindings& findings);
std::optional<DepthPsfFindings> depth_psf_findings(const Json& report);

/// The parts of single steps of a run.
Json to_json(const std::vector<SpreadCell>& cells);
std::vector<SpreadCell> spread_cells_from(const Json& list);
Json to_json(const EyesBeyond& eyes);
EyesBeyond eyes_beyond_from(const Json& entry);
Json to_json(const std::vector<BandingRow>& rows);
std::vector<BandingRow> banding_rows_from(const Json& list);

}  // namespace sturm
