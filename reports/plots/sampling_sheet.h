#pragma once
#include <filesystem>
#include <vector>

#include "compare/studies/samplings/sampling_findings.h"
#include "reports/plots/figure.h"

namespace sturm {

/// Contact sheets of a report's section "sampling_study", one for each sampler: a row for each configuration, a column
/// for each sampling, the bias and the noise under each picture. The pictures are read from the run folder; one that is
/// not there leaves its frame empty.
std::vector<Figure> sampling_sheets(const SamplingFindings& found, const std::filesystem::path& run_folder);

}  // namespace sturm
