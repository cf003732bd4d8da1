#pragma once
#include <filesystem>
#include <span>

#include "io/json/json.h"
#include "reports/markup/html.h"

namespace sturm {

class ViewerPayload;

/// The parts of the report page, in the order in which they are read; each is a <section> or <header>, or
/// nothing when the report has nothing for it. Those with pictures to explore put their numbers into the page's one
/// payload.
Html verdict_section(const Json& report);
Html gates_section(const Json& report);
Html gate_power_section(const Json& report);
Html case_section(const Json& report);
Html sin2_section(const Json& report);
Html lens_study_section(const Json& report, const std::filesystem::path& run_folder);
Html design_study_section(const Json& report, const std::filesystem::path& run_folder);
Html sin2_study_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
Html bench_section(const Json& report, const std::filesystem::path& run_folder);
Html sampling_section(const Json& report, const std::filesystem::path& run_folder);
Html figure_section(const Json& report, const std::filesystem::path& run_folder);
Html psf_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
Html picture_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
Html ellipse_section(const Json& report);
Html provenance_section(const Json& report);

/// A section of the report page.
struct ReportSection {
  const char* id;     ///< of its HTML element
  const char* title;  ///< in the page's navigation
  /// Nothing when the report has nothing for it.
  Html (*draw)(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);
  /// Key in the report's verdict of the sentence that says what the section measured, and its heading at the head of
  /// the page; null where it has none.
  const char* sentence_key = nullptr;
  const char* sentence_heading = nullptr;
};

/// All sections after the verdict, in reading order. A further section is a further line there.
std::span<const ReportSection> report_sections();

}  // namespace sturm
