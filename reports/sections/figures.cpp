#include <nlohmann/json.hpp>

#include "reports/markup/markup.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"

namespace sturm {

std::string figure_section(const Json& report, const std::filesystem::path& run_folder) {
  std::string html;
  for (const Json& figure : figures_of(report, "")) html += figure_html(figure, run_folder);
  return html.empty() ? "" : element("section", "id=\"figures\"", element("h2", "", "Figures") + html);
}

}  // namespace sturm
