#pragma once
#include "compare/findings/sections.h"
#include "compare/gates/statistic.h"
#include "io/json/json.h"

namespace sturm {

/// All statistics, computed from report.json alone (missing or mistyped parts count as absent).
///
// clang-format off
/// | name | what |
/// |---|---|
/// | conoid_reference_max_relative_error | conoid (semi-axes and covariance) against the independent reference |
/// | sin2_reference_max_relative_error | closed form of sin² against the independent reference |
/// | matrix_vs_conoid_max_z, …_max_relative | `power_matrix` rays and conoid: largest abs(z), relative Frobenius error |
/// | thin_lens_vs_conoid_max_z, …_max_relative | `thin_lens` rays and conoid, cases with CYL = 0 only |
/// | sin2_vs_closed_form_max_z, …_max_relative | `sin2_radial` rays and their closed form |
/// | sin2_vs_conoid_min_z | `sin2_radial` rays and conoid, smallest abs(z) over the cases with abs(CYL) ≥ 0.5 D |
/// | sin2_vs_conoid_min_relative_difference_ratio, …_max_… | there: measured relative difference ÷ that of the closed form |
/// | psf_matrix_axis_max_z | PSFs of `power_matrix` along the predicted axes; the error includes the pixel grid's |
/// | psf_matrix_axis_max_relative | there: relative error of axes of at least 4 px |
/// | psf_matrix_centroid_max_z | there: largest deviation of the centroid from the chief ray's place, x or y, of a spot or of all together |
/// | image_ssim_display/ID | prediction and `power_matrix` image ID, SSIM in display space |
/// | image_ssim_display_min | the smallest of them |
/// | image_ssim_below_noise_floor_max | largest SSIM of two halves of the samples minus SSIM of the prediction |
/// | image_ssim_gain_of_matrix_over_sin2_min | SSIM with `power_matrix` minus SSIM with `sin2_radial` |
/// | image_matrix_rmse_over_noise_floor_max | RMSE of prediction and `power_matrix` image ÷ RMSE of two halves of the samples |
/// | image_sin2_rmse_over_noise_floor_min | the same of prediction and `sin2_radial` image |
/// | image_light_max_deviation | prediction and `power_matrix` image: largest abs(light of the prediction ÷ light of the image − 1) |
/// | image_shift_max_px | there: largest displacement of the one against the other (compare/metrics/displacement.h) |
/// | lens_order_max_deviation | lens study, oblique views, no spline: largest abs(order of the absolute covariance error − 4) |
/// | lens_relative_order_max_deviation | there, views whose larger blur is at least 0.5 D: largest abs(relative order − 2) |
/// | lens_limit_max_relative | views of at least 0.5 D: real rays extrapolated to the pupil 0 against ray transfer, relative Frobenius |
/// | lens_spline_relative_order_min | smallest relative order in oblique views of at least 0.5 D through spline surfaces |
/// | lens_published_revolution_max_D | first-order error of `published`: on the axis of lenses of revolution, all views of a round eye's |
/// | lens_published_min_of_largest_D | smallest over the lenses of eyes with a cylinder of the largest first-order error of `published` |
/// | lens_previous_unscaled_max | `previous` with the true magnification in place of its own, against exact first order |
/// | lens_previous_min_of_largest_D | smallest over all lenses of the largest first-order error of `previous` |
/// | agreement_ssim_display/ID/KIND, …_min/KIND | predicted and path-traced view ID: SSIM in display space  |
/// | agreement_times_faster/ID/KIND, …_min/KIND | path tracing to the same error over that prediction, in time |
/// | sampling_unbiased_max_z | sampling study, `uniform_disk`, `uniform_polar_weighted` and all of `pinhole`: largest abs(z) of the bias |
/// | sampling_raw_polar_min_z | smallest z of the bias of `uniform_polar` over all ray models but `pinhole` |
/// | design_max_median_share | design study: largest median over wearers of the share of gazes that are blurred |
/// | design_max_cylinder | design study: largest cylinder of the error as worn [D] |
/// | sin2_study/NAME | the entry NAME of `sin2_study.checks` in the report: its value, cases and worst case |
/// | sin2_study/gallery_sin2_over_noise_min | gallery views with a cylinder: smallest total variation of sin² ÷ that of two runs of theory |
/// | sin2_study/gallery_repaired_over_noise_max | all gallery views: the largest of sin² with the tangential term |
/// | bench/VIEW/METHOD/…, bench/broken_requirements | run time against error (compare/findings/bench.h) |
/// | must_fail/ID | the statistic that mutant ID was to spoil |
/// | must_fail_min_value_over_bound | smallest value ÷ bound over all mutants; none if one says that it did not fail |
/// | mutation_min_gates | section `gate_power`: smallest number of gates that notice a mutation |
// clang-format on
Statistics statistics_of(const Json& report, std::span<const FindingSection> sections = finding_sections());

}  // namespace sturm
