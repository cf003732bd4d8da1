#pragma once
#include <string>
#include <vector>

#include "compare/studies/bench/measured_view.h"
#include "io/json/json.h"
#include "io/specs/experiment/bench_spec.h"

namespace sturm {

/// What a view's measurements say, as the members "methods" (points, slopes, times to levels), "pareto", "crossovers"
/// and "ratios" of its entry in a report (sturm.bench_report/1). Ratios are relative to the view's first method.
/// Methods whose filtered picture was measured have points, slopes and times alone: they are biased.
Json evaluated(const MeasuredView& view, const std::vector<BenchMethod>& methods,
               const std::vector<ErrorLevel>& levels);

/// The report's list "requirements": each requirement in each of its views.
Json evaluated(const std::vector<BenchRequirement>& requirements, const std::vector<MeasuredView>& views);

/// The report's "verdict": {passed, sentence}. Without requirements it has passed.
Json bench_verdict(const Json& requirements);

/// The members of `errors` as a JSON object under the names of sturm.bench_report/1 ("mse" in place of "rmse"), and
/// back.
Json picture_errors_json(const PictureErrors& errors);
PictureErrors picture_errors_from(const Json& json);

}  // namespace sturm
