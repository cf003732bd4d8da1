#include "compare/report_html.h"

#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/report_json.h"
#include "compare/report_markup.h"
#include "compare/report_sections.h"

namespace sturm {

/// Generated from compare/report_assets by the build.
const std::vector<std::pair<std::string_view, std::string_view>>& embedded_report_assets();

namespace {

std::string asset(std::string_view name) {
  for (const auto& [file, text] : embedded_report_assets()) {
    if (file == name) return std::string(text);
  }
  throw std::logic_error("the report's " + std::string(name) + " was not compiled in");
}

struct Part {
  std::string id, name, html;
};

std::string navigation(const std::vector<Part>& parts) {
  std::string items;
  for (const Part& part : parts) {
    if (!part.html.empty()) items += element("li", "", "<a href=\"#" + part.id + "\">" + part.name + "</a>");
  }
  return items.empty() ? "" : element("nav", "aria-label=\"Contents\"", element("ol", "", items));
}

}  // namespace

std::string render_report_html(const Json& report, const std::filesystem::path& run_folder) {
  const std::vector<Part> parts = {{"gates", "Gates", gates_section(report)},
                                   {"sin2", "sin²", sin2_section(report)},
                                   {"lens_study", "Spectacles", lens_study_section(report, run_folder)},
                                   {"sampling_study", "Pupil samplings", sampling_section(report, run_folder)},
                                   {"figures", "Figures", figure_section(report, run_folder)},
                                   {"psfs", "Point-spread functions", psf_section(report, run_folder)},
                                   {"images", "Images", image_section(report, run_folder)},
                                   {"ellipses", "All ellipses", ellipse_section(report)},
                                   {"provenance", "Provenance", provenance_section(report)}};
  std::string body = verdict_section(report) + navigation(parts);
  for (const Part& part : parts) body += part.html;
  const std::string title = text_at(report, "title");
  const std::string head = "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
                           element("title", "", title.empty() ? "Sturm report" : escaped(title)) +
                           element("style", "", asset("report.css"));
  return "<!DOCTYPE html>\n" +
         element("html", "lang=\"en\"",
                 element("head", "", head) + element("body", "", element("main", "", body) + element("script", "", asset("report.js"))));
}

}  // namespace sturm
