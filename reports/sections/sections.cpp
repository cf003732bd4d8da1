#include "reports/sections/sections.h"

#include <array>

#include "reports/sections/depth_psf.h"

namespace sturm {

namespace {

using Folder = std::filesystem::path;

/// Sections that need less than others do.
template <Html (*section)(const Json&)>
Html of_report(const Json& report, const Folder&, ViewerPayload&) {
  return section(report);
}

template <Html (*section)(const Json&, const Folder&)>
Html of_folder(const Json& report, const Folder& run_folder, ViewerPayload&) {
  return section(report, run_folder);
}

}  // namespace

std::span<const ReportSection> report_sections() {
  static constexpr std::array sections = {
      ReportSection{"gates", "Gates", of_report<gates_section>},
      ReportSection{"gate_power", "What the gates can see", of_report<gate_power_section>},
      ReportSection{"cases", "Cases", of_report<case_section>},
      ReportSection{"sin2", "sin²", of_report<sin2_section>, "sin2_sentence", "What was measured of sin²"},
      ReportSection{"sin2_study", "sin² study", sin2_study_section, "sin2_study_sentence", "The verdict on sin²"},
      ReportSection{"lens_study", "Spectacles", of_folder<lens_study_section>, "lens_sentence",
                    "What was measured of conoid tracing"},
      ReportSection{"depth_psf_study", "Point spreads over depth", of_folder<depth_psf_section>},
      ReportSection{"design_study", "Lens designs", of_folder<design_study_section>, "design_sentence",
                    "What wearers see through the designs"},
      ReportSection{"sampling_study", "Pupil samplings", of_folder<sampling_section>},
      ReportSection{"bench", "Run time against error", of_folder<bench_section>},
      ReportSection{"figures", "Figures", of_folder<figure_section>},
      ReportSection{"psfs", "Point-spread functions", psf_section},
      ReportSection{"pictures", "Pictures", picture_section},
      ReportSection{"ellipses", "All ellipses", of_report<ellipse_section>},
      ReportSection{"provenance", "Provenance", of_report<provenance_section>},
  };
  return sections;
}

}  // namespace sturm
