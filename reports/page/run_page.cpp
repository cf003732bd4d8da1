#include "reports/page/run_page.h"

#include <vector>

#include "io/json/stored.h"
#include "reports/markup/html.h"
#include "reports/sections/sections.h"
#include "reports/viewer/html_page.h"
#include "reports/viewer/viewer.h"

namespace sturm {

namespace {

struct Part {
  std::string id, name;
  Html html;
};

Html navigation(const std::vector<Part>& parts) {
  Html items;
  for (const Part& part : parts) {
    if (!part.html.empty()) items += element("li", inline_element("a", {{"href", "#" + part.id}}, text(part.name)));
  }
  return items.empty() ? Html() : element("nav", {{"aria-label", "Contents"}}, element("ol", items));
}

}  // namespace

std::string render_report_html(const Json& report, const std::filesystem::path& run_folder) {
  ViewerPayload payload;
  const PictureSections pictures = picture_sections(report, run_folder, payload);
  const std::vector<Part> parts = {{"gates", "Gates", gates_section(report)},
                                   {"gate_power", "What the gates can see", gate_power_section(report)},
                                   {"cases", "Cases", case_section(report)},
                                   {"sin2", "sin²", sin2_section(report)},
                                   {"sin2_study", "sin² study", sin2_study_section(report, run_folder, payload)},
                                   {"lens_study", "Spectacles", lens_study_section(report, run_folder)},
                                   {"sampling_study", "Pupil samplings", sampling_section(report, run_folder)},
                                   {"bench", "Run time against error", bench_section(report, run_folder)},
                                   {"figures", "Figures", figure_section(report, run_folder)},
                                   {"psfs", "Point-spread functions", psf_section(report, run_folder, payload)},
                                   {"images", "Images", pictures.images},
                                   {"agreement", "Predictions", pictures.agreement},
                                   {"ellipses", "All ellipses", ellipse_section(report)},
                                   {"provenance", "Provenance", provenance_section(report)}};
  Html body = verdict_section(report) + navigation(parts);
  for (const Part& part : parts) body += part.html;
  body += payload.html();
  const std::string title = text_at(report, "title");
  return html_page(title.empty() ? "Sturm report" : title, body);
}

}  // namespace sturm
