#include "compare/findings/case_rows.h"
#include "compare/studies/lens/lens_study_errors.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

const char* name_of(CaseStatus status) {
  constexpr const char* names[] = {"failed", "no result", "differs", "agrees", "measured"};
  return names[static_cast<int>(status)];
}

Html table_of(const Measurements& cases) {
  HtmlTable table("All cases, failures first", "cases sortable filterable",
                  {{"Case"_html, false},
                   {"Status"_html, false},
                   {"Ray model, prediction or method"_html, false},
                   {"What is compared"_html, false},
                   {"Value"_html},
                   {"Largest |z| [σ]"_html}});
  for (const Measurement& c : cases) {
    const std::string status = name_of(*c.listed_as);
    const std::string css_class = *c.listed_as == CaseStatus::Failed ? "fail" : "";
    table.add_row({inline_element("a", {{"href", "#" + c.section}}, text_or_dash(c.subject)),
                   Cell(text(status), static_cast<double>(*c.listed_as)),
                   code_html(c.model),
                   text(c.quantity),
                   {number_html(c.value, 3), c.value},
                   {number_html(c.z, 3), c.z}},
                  RowState{css_class, status});
  }
  return table.html();
}

}  // namespace

Html case_section(const Json& report) {
  const Measurements cases = case_rows(report);
  if (cases.empty()) return {};
  return element(
      "section", {{"id", "cases"}},
      element("h2", "Cases"_html) +
          element(
              "p",
              "<i>Failed</i>: the case that decided a failed gate. <i>Differs</i> and <i>agrees</i>: for ellipses and "
              "pupil samplings, whether |z| is above what chance alone exceeds in one report of a hundred, counting "
              "every one of them; for images and predictions, whether the RMSE is above the path tracer's own noise "
              "floor; for point spreads, whether the distance from theory is above 1.5 times that of two runs of "
              "theory; for spectacles, whether the error from real rays is anywhere above "_html +
                  text(plain_number(defocus_that_matters_D)) +
                  " D, a fifth of the smallest step that lenses are ordered in. Some ray models are here because they "
                  "differ. <i>Measured</i>: no test of the single case."_html) +
          table_of(cases));
}

}  // namespace sturm
