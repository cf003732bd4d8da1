#include "experiments/toy_study/toy_page.h"

#include "experiments/toy_study/toy_findings.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"

namespace sturm {

Html toy_study_section(const Json& report, const std::filesystem::path&, ViewerPayload&) {
  const std::optional<ToyFindings> found = toy_findings(report);
  if (!found) return {};
  HtmlTable table("Radius of the blur", "sortable",
                  {{"Defocus [D]"_html}, {"Traced [arcmin]"_html}, {"By the formula [arcmin]"_html}});
  for (const ToyEntry& entry : found->entries)
    table.add_row({exact_html(entry.defocus_D), number_html(entry.traced_arcmin), number_html(entry.expected_arcmin)});
  return element("section", {{"id", "toy_study"}}, element("h2", "Toy study"_html) + table.html());
}

}  // namespace sturm
