#include "compare/studies/depth_psf/depth_psf_findings.h"

#include <algorithm>
#include <cmath>

namespace sturm {

template <>
inline constexpr auto record_members<SpreadCell> =
    std::tuple{member("light", &SpreadCell::light),
               member("pupil_mm", &SpreadCell::pupil_mm),
               member("defocus_D", &SpreadCell::defocus_D),
               member("total_variation", &SpreadCell::total_variation),
               member("rays_r50_arcmin", &SpreadCell::rays_r50_arcmin),
               member("waves_r50_arcmin", &SpreadCell::waves_r50_arcmin)};

template <>
inline constexpr auto record_members<EyesBeyond> =
    std::tuple{member("id", &EyesBeyond::id),
               member("title", &EyesBeyond::title),
               member("pupil_mm", &EyesBeyond::pupil_mm),
               member("eyes", &EyesBeyond::eyes),
               member("rms_um", &EyesBeyond::rms_um),
               member("defocus_D", &EyesBeyond::defocus_D),
               member("r80_arcmin", &EyesBeyond::r80_arcmin),
               member("share_above_step", &EyesBeyond::share_above_step)};

template <>
inline constexpr auto record_members<BandingRow> = std::tuple{member("spacing_px", &BandingRow::spacing_px),
                                                              member("weights", &BandingRow::weights),
                                                              member("pupil_parts", &BandingRow::pupil_parts),
                                                              member("planes", &BandingRow::planes),
                                                              member("rmse", &BandingRow::rmse),
                                                              member("largest_step", &BandingRow::largest_step)};

template <>
inline constexpr auto record_members<DepthPsfFindings> =
    std::tuple{member("map", &DepthPsfFindings::map), member("eyes", &DepthPsfFindings::eyes),
               member("banding", &DepthPsfFindings::banding)};

Quartiles quartiles_of(std::vector<double> values) {
  if (values.size() < 2) return {};
  std::sort(values.begin(), values.end());
  const double last = static_cast<double>(values.size() - 1);
  Quartiles quartiles;
  for (int q = 0; q < 3; ++q) {
    const double at = std::clamp(0.25 * (q + 1) * static_cast<double>(values.size() + 1) - 1.0, 0.0, last);
    const auto below = static_cast<std::size_t>(at), above = std::min(below + 1, values.size() - 1);
    quartiles[static_cast<std::size_t>(q)] = std::lerp(values[below], values[above], at - std::floor(at));
  }
  return quartiles;
}

Json to_json(const DepthPsfFindings& findings) {
  return json_from(findings);
}

std::optional<DepthPsfFindings> depth_psf_findings(const Json& report) {
  return record_from<std::optional<DepthPsfFindings>>(value_at(report, "depth_psf_study"));
}

Json to_json(const std::vector<SpreadCell>& cells) {
  return json_from(cells);
}

std::vector<SpreadCell> spread_cells_from(const Json& list) {
  return record_from<std::vector<SpreadCell>>(list);
}

Json to_json(const EyesBeyond& eyes) {
  return json_from(eyes);
}

EyesBeyond eyes_beyond_from(const Json& entry) {
  return record_from<EyesBeyond>(entry);
}

Json to_json(const std::vector<BandingRow>& rows) {
  return json_from(rows);
}

std::vector<BandingRow> banding_rows_from(const Json& list) {
  return record_from<std::vector<BandingRow>>(list);
}

}  // namespace sturm
