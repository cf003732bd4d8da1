#pragma once
#include <filesystem>
#include <string>

#include "compare/studies/bench/bench_findings.h"
#include "io/json/json.h"

namespace sturm {

/// A benchmark's report (sturm.bench_report/1) as one page that needs nothing else; figures and pictures are read from
/// `run_folder`, what is missing leaves a note. Null numbers are shown as "–". The page is also well-formed XML.
std::string bench_report_html(const Json& report, const std::filesystem::path& run_folder);

/// Which method reaches each level first, and when the view's first one does: a sentence per view;
/// null without levels.
Json bench_sentence(const BenchFindings& found);

/// The same numbers as lines of text for a terminal: per view the settings with seconds and errors, slopes and times,
/// then the requirements and the verdict. The machine stands above.
std::string bench_report_text(const BenchFindings& found);

}  // namespace sturm
