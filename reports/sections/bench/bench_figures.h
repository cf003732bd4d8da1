#pragma once
#include <string>
#include <vector>

#include "compare/studies/bench/bench_findings.h"
#include "reports/plots/figure.h"

namespace sturm {

/// The plots of one view of a report (sturm.bench_report/1): RMSE against samples, and RMSE, trimmed relative MSE and
/// every error that levels were asked for against seconds with the Pareto front. `command` is what draws them again.
/// Throws RuntimeFailure where gnuplot is missing.
std::vector<Figure> bench_figures(const BenchViewResult& view, const std::string& command);

/// The same for the view of an experiment's report: ids that start with "bench_", in the section that the report's page
/// shows them in.
std::vector<Figure> bench_figures_of_experiment(const BenchViewResult& view, const std::string& command);

/// The section of the figures of the view `id` in an experiment's report.
std::string bench_figure_section(const std::string& id);

}  // namespace sturm
