#pragma once
#include "compare/gates/extreme_statistic.h"

namespace sturm {

/// Adds, for each entry ID of a report's "agreement" and each prediction KIND of it:
/// - `agreement_ssim_display/ID/KIND`: mean similarity of single predictions with the path-traced mean, with its
/// standard error;
/// - `agreement_ssim_without_noise/ID/KIND`: the same with the noise of both extrapolated away, 1 −
/// similarity_loss/method;
/// - `agreement_times_faster/ID/KIND`: path tracing to the same squared error over predicting, in time;
/// and over all entries the smallest, `agreement_ssim_display_min/KIND` and `agreement_times_faster_min/KIND`.
void add_agreement_statistics(const Json& report, Statistics& out);

}  // namespace sturm
