#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "io/json/json.h"
#include "reports/sections/sections.h"

namespace sturm {

/// The report of a run ("sturm.report/1") as one HTML page that needs nothing else: style, pictures and plots are
/// inside it. EXR files that the report names are read from `run_folder`; a picture that is missing or unreadable
/// leaves a note in its place. Missing sections are left out, null numbers are shown as "–". The page is also
/// well-formed XML, which its tests rely on. Throws RuntimeFailure where a plot is due and gnuplot cannot be run.
std::string render_report_html(const Json& report, const std::filesystem::path& run_folder,
                               std::span<const ReportSection> sections = report_sections());

}  // namespace sturm
