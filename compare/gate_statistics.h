#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "io/json.h"

namespace sturm {

/// One number that sums up a report, over all the cases that it speaks of.
struct Statistic {
  std::optional<double> value;        ///< none when there is no case, or when any case has no number: missing evidence is not evidence
  std::optional<double> uncertainty;  ///< one standard error, of the worst case
  std::uint64_t cases = 0;
  std::string worst_case;  ///< the case that `value` comes from, or the one without a number
};

/// All statistics, computed from report.json alone (missing or mistyped parts count as absent).
///
/// | name | what |
/// |---|---|
/// | conoid_reference_max_relative_error | conoid (semi-axes and covariance) against the independent reference |
/// | sin2_reference_max_relative_error | closed form of sin² against the independent reference |
/// | matrix_vs_conoid_max_z, …_max_relative | `power_matrix` rays against the conoid: largest abs(z), largest relative Frobenius error |
/// | thin_lens_vs_conoid_max_z, …_max_relative | `thin_lens` rays against the conoid, cases with CYL = 0 only |
/// | sin2_vs_closed_form_max_z, …_max_relative | `sin2_radial` rays against their closed form |
/// | sin2_vs_conoid_min_z | `sin2_radial` rays against the conoid, smallest abs(z) over the cases with abs(CYL) ≥ 0.5 D |
/// | sin2_vs_conoid_min_relative_difference_ratio, …_max_… | there: measured relative difference ÷ the one that the closed form predicts |
/// | psf_matrix_axis_max_z | rendered PSFs of `power_matrix` along the predicted axes; the error includes what the pixel grid does to a
/// short axis | | psf_matrix_axis_max_relative | there: relative error of axes of at least 4 px | | image_ssim_display/ID | predicted
/// against `power_matrix` path traced, SSIM in display space, image ID | | image_ssim_display_min | the smallest of them | |
/// image_ssim_below_noise_floor_max | largest SSIM of two seeds minus SSIM of prediction and path tracing | |
/// image_ssim_gain_of_matrix_over_sin2_min | SSIM with `power_matrix` minus SSIM with `sin2_radial`, images that have both | | must_fail/ID
/// | the statistic that mutant ID was to spoil | | must_fail_min_value_over_bound | smallest value ÷ bound over all mutants; none if one of
/// them says that it did not fail |
std::map<std::string, Statistic> statistics_of(const Json& report);

}  // namespace sturm
