#include <cmath>

#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/sin2_plots.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html pair_html(const Json& pair) {
  return number_html(number_at(pair, "0")) + " × "_html + number_html(number_at(pair, "1"));
}

Html explanation() {
  return R"(<p>A ray that is bent by <i>P</i>(φ) = <i>S</i> + <i>C</i> sin²(φ − α) stays in its own meridian. The wavefront also
turns rays sideways, by <i>r C</i> sin(φ − α) cos(φ − α); sin² leaves that out. With <i>V</i><sub>1</sub>, <i>V</i><sub>2</sub> the
principal vergence errors at the target and <i>a</i> the pupil's radius, the second moments of a uniform pupil give the semi-axes</p>
<table class="formula"><tbody>
<tr><th scope="row">wavefront theory</th><td><i>a</i> |<i>V</i><sub>1</sub>|</td><td><i>a</i> |<i>V</i><sub>2</sub>|</td></tr>
<tr><th scope="row">sin²</th><td><i>a</i> √((5<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + <i>V</i><sub>2</sub>²) / 8)</td>
<td><i>a</i> √((<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + 5<i>V</i><sub>2</sub>²) / 8)</td></tr></tbody></table>
<p>The closed forms are computed without any ray, the measured values from traced rays; neither is fitted to the other.</p>
)"_html;
}

Html headline(const Json& sin2) {
  const Json& ratio = value_at(sin2, "ratio_of_difference_of_principal_variances");
  const Json& lost = value_at(sin2, "lost_total_variance");
  HtmlTable table("What sin² rays lose, measured against prediction", "compact",
                  {{"Quantity"_html, false}, {"Measured (median)"_html}, {"Predicted"_html}, {"Worst deviation"_html}});
  table.add_row({"difference of the principal variances, sin² ÷ true"_html,
                 number_html(number_at(ratio, "measured_median"), 6), exact_html(number_at(ratio, "predicted")),
                 number_html(number_at(ratio, "worst_deviation"), 2)});
  table.add_row({"total variance lost ÷ (<i>a</i>²<i>C</i>²/16)"_html, absent_html(), "1"_html,
                 number_html(number_at(lost, "worst_deviation_relative"), 2)});
  return element("p", "Cases with a cylinder: "_html + count_html(number_at(sin2, "cases_with_cylinder")) + "."_html) +
         table.html();
}

Html case_table(const Json& rows) {
  HtmlTable table("Semi-axes (2 × standard deviation) of the blur, major × minor", "sortable",
                  {{"Case"_html, false},
                   {"V<sub>1</sub> [D]"_html},
                   {"V<sub>2</sub> [D]"_html},
                   {"True [arcmin]"_html},
                   {"sin² rays, measured [arcmin]"_html},
                   {"sin², closed form [arcmin]"_html},
                   {"Major, sin² ÷ true"_html},
                   {"Minor, sin² ÷ true"_html}});
  for (const Json& row : rows) {
    const auto v1 = number_at(row, "V1_D"), v2 = number_at(row, "V2_D");
    const auto major = number_at(row, "ratio_major"), minor = number_at(row, "ratio_minor");
    table.add_row(
        {text_or_dash(text_at(row, "case")),
         {number_html(v1), v1},
         {number_html(v2), v2},
         {pair_html(value_at(row, "true_semi_axes_arcmin")), number_at(row, "true_semi_axes_arcmin/0")},
         {pair_html(value_at(row, "sin2_semi_axes_arcmin")), number_at(row, "sin2_semi_axes_arcmin/0")},
         {pair_html(value_at(row, "closed_form_semi_axes_arcmin")), number_at(row, "closed_form_semi_axes_arcmin/0")},
         {number_html(major), major},
         {number_html(minor), minor}});
  }
  constexpr std::size_t rows_that_stay_open = 12;
  return folded("All "_html + text(std::to_string(rows.size())) + " cases with their semi-axes"_html, table.html(),
                rows.size() <= rows_that_stay_open);
}

}  // namespace

Html sin2_section(const Json& report) {
  const Json& sin2 = value_at(report, "sin2");
  const Html by_cylinder = difference_plot(report);
  if (!sin2.is_object() && by_cylinder.empty()) return {};
  Html html = element("h2", "sin² against its closed form"_html) + explanation();
  if (sin2.is_object()) html += headline(sin2);
  if (const Html plots = sin2_ratio_plots(report); !plots.empty()) {
    html += element("figure",
                    element("div", {{"class", "two"}}, plots) +
                        element("figcaption",
                                "Every case with a cylinder. Left of t = 0 the target lies between the two "
                                "focal lines. A focal line has no true width, so its minor ratio is not shown."_html));
  }
  if (!by_cylinder.empty()) {
    html += element(
        "figure",
        by_cylinder +
            element("figcaption",
                    "‖rays − conoid‖ / ‖conoid‖ of the covariance matrices. Power-matrix rays differ only by their "
                    "sampling noise; sin² and spherical-equivalent rays differ by physics. A difference of zero has no "
                    "place on a "
                    "logarithmic axis."_html));
  }
  if (const Json& rows = array_at(sin2, "table"); !rows.empty()) html += case_table(rows);
  return element("section", {{"id", "sin2"}}, html);
}

}  // namespace sturm
