#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "io/json/json.h"

namespace sturm {

class ViewerPayload;

/// The parts of the report page, in the order in which they are read; each is an HTML <section> or <header>,
/// or "" when the report has nothing for it. Those with pictures to explore put their numbers into the page's one
/// payload.
std::string verdict_section(const Json& report);
std::string gates_section(const Json& report);
std::string gate_power_section(const Json& report);
std::string case_section(const Json& report);
std::string sin2_section(const Json& report);
std::string lens_study_section(const Json& report, const std::filesystem::path& run_folder);
std::string sin2_study_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
std::string bench_section(const Json& report, const std::filesystem::path& run_folder);
std::string sampling_section(const Json& report, const std::filesystem::path& run_folder);
std::string figure_section(const Json& report, const std::filesystem::path& run_folder);
std::string psf_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
std::string image_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
std::string agreement_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
std::string ellipse_section(const Json& report);
std::string provenance_section(const Json& report);

/// A section of the report page.
struct ReportSection {
  const char* id;     ///< of its HTML element
  const char* title;  ///< in the page's navigation
  /// "" when the report has nothing for it.
  std::string (*draw)(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
};

/// All sections after the verdict, in reading order. A further section is a further line there.
std::span<const ReportSection> report_sections();

}  // namespace sturm
