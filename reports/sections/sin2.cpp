#include "compare/findings/sin2.h"

#include <cmath>

#include "compare/findings/ellipses.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/sin2_plots.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Cell semi_axes_cell(const std::optional<Eigen::Vector2d>& axes) {
  const Number major = axes ? Number(axes->x()) : std::nullopt, minor = axes ? Number(axes->y()) : std::nullopt;
  return {number_html(major) + " × "_html + number_html(minor), major};
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

Html headline(const Sin2Findings& sin2) {
  const VarianceRatio ratio = sin2.ratio.value_or(VarianceRatio{});
  HtmlTable table("What sin² rays lose, measured against prediction", "compact",
                  {{"Quantity"_html, false}, {"Measured (median)"_html}, {"Predicted"_html}, {"Worst deviation"_html}});
  table.add_row({"difference of the principal variances, sin² ÷ true"_html, number_html(ratio.measured_median, 6),
                 exact_html(ratio.predicted), number_html(ratio.worst_deviation, 2)});
  table.add_row({"total variance lost ÷ (<i>a</i>²<i>C</i>²/16)"_html, absent_html(), "1"_html,
                 number_html(sin2.worst_deviation_of_lost_variance, 2)});
  return element("p", "Cases with a cylinder: "_html + count_html(sin2.cases_with_cylinder) + "."_html) + table.html();
}

Html case_table(const std::vector<Sin2Case>& rows) {
  HtmlTable table("Semi-axes (2 × standard deviation) of the blur, major × minor", "sortable",
                  {{"Case"_html, false},
                   {"V<sub>1</sub> [D]"_html},
                   {"V<sub>2</sub> [D]"_html},
                   {"True [arcmin]"_html},
                   {"sin² rays, measured [arcmin]"_html},
                   {"sin², closed form [arcmin]"_html},
                   {"Major, sin² ÷ true"_html},
                   {"Minor, sin² ÷ true"_html}});
  for (const Sin2Case& row : rows)
    table.add_row({text_or_dash(row.id),
                   {number_html(row.high_D), row.high_D},
                   {number_html(row.low_D), row.low_D},
                   semi_axes_cell(row.true_semi_axes_arcmin),
                   semi_axes_cell(row.sin2_semi_axes_arcmin),
                   semi_axes_cell(row.closed_form_semi_axes_arcmin),
                   {number_html(row.ratio_major), row.ratio_major},
                   {number_html(row.ratio_minor), row.ratio_minor}});
  constexpr std::size_t rows_that_stay_open = 12;
  return folded("All "_html + text(std::to_string(rows.size())) + " cases with their semi-axes"_html, table.html(),
                rows.size() <= rows_that_stay_open);
}

}  // namespace

Html sin2_section(const Json& report) {
  const std::optional<Sin2Findings> sin2 = read_sin2(report);
  const Html by_cylinder = difference_plot(read_ellipses(report).cases);
  if (!sin2 && by_cylinder.empty()) return {};
  Html html = element("h2", "sin² against its closed form"_html) + explanation();
  if (sin2) html += headline(*sin2);
  if (const Html plots = sin2 ? sin2_ratio_plots(sin2->table) : Html(); !plots.empty()) {
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
  if (sin2 && !sin2->table.empty()) html += case_table(sin2->table);
  return element("section", {{"id", "sin2"}}, html);
}

}  // namespace sturm
