#include "experiments/toy_study/toy_page.h"

#include "experiments/toy_study/toy_findings.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"

namespace sturm {

std::string toy_study_section(const Json& report, const std::filesystem::path&, ViewerPayload&) {
  const std::optional<ToyFindings> found = toy_findings(report);
  if (!found) return "";
  HtmlTable table("Radius of the blur", "sortable",
                  {{"Defocus [D]"}, {"Traced [arcmin]"}, {"By the formula [arcmin]"}});
  for (const ToyEntry& entry : found->entries)
    table.add_row({exact_html(entry.defocus_D), number_html(entry.traced_arcmin), number_html(entry.expected_arcmin)});
  return element("section", "id=\"toy_study\"", element("h2", "", "Toy study") + table.html());
}

}  // namespace sturm
