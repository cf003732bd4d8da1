#include <nlohmann/json.hpp>

#include "reports/markup/html.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"

namespace sturm {

Html figure_section(const Json& report, const std::filesystem::path& run_folder) {
  Html html;
  for (const Json& figure : figures_of(report, "")) html += figure_html(figure, run_folder);
  return html.empty() ? Html() : element("section", {{"id", "figures"}}, element("h2", "Figures"_html) + html);
}

}  // namespace sturm
