#include "reports/page/run_page.h"

#include <vector>

#include "io/json/stored.h"
#include "reports/markup/html.h"
#include "reports/viewer/html_page.h"
#include "reports/viewer/viewer.h"

namespace sturm {

namespace {

struct Part {
  const ReportSection& section;
  Html html;
};

Html navigation(const std::vector<Part>& parts) {
  Html items;
  for (const Part& part : parts) {
    if (!part.html.empty())
      items +=
          element("li", inline_element("a", {{"href", "#" + std::string(part.section.id)}}, text(part.section.title)));
  }
  return items.empty() ? Html() : element("nav", {{"aria-label", "Contents"}}, element("ol", items));
}

}  // namespace

std::string render_report_html(const Json& report, const std::filesystem::path& run_folder,
                               std::span<const ReportSection> sections) {
  ViewerPayload payload;
  std::vector<Part> parts;
  for (const ReportSection& section : sections) parts.push_back({section, section.draw(report, run_folder, payload)});
  Html body = verdict_section(report) + navigation(parts);
  for (const Part& part : parts) body += part.html;
  body += payload.html();
  const std::string title = text_at(report, "title");
  return html_page(title.empty() ? "Sturm report" : title, body);
}

}  // namespace sturm
