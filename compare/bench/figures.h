#pragma once
#include <string>
#include <vector>

#include "compare/figure.h"

namespace sturm {

/// The plots of one view of a report (sturm.bench_report/1): RMSE against samples, and RMSE and trimmed relative MSE against seconds with
/// the Pareto front. `command` is what draws them again. Throws RuntimeFailure where gnuplot is missing.
std::vector<Figure> bench_figures(const Json& view, const std::string& command);

}  // namespace sturm
