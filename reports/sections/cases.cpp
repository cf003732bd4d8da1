#include "reports/sections/cases.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/statistics/test_family.h"
#include "compare/studies/lens/lens_study_errors.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

constexpr int components = 3;  ///< of a covariance: z_max is the largest of so many

using Case = ReportCase;
using Status = CaseStatus;

const char* name_of(Status status) {
  constexpr const char* names[] = {"failed", "no result", "differs", "agrees", "measured"};
  return names[static_cast<int>(status)];
}

void add_ellipses(const Json& report, std::vector<Case>& cases) {
  for (const Json& item : array_at(report, "ellipses/cases")) {
    for (const Json& rays : array_at(item, "rays")) {
      const bool closed = value_at(rays, "against_closed_form").is_object();
      const Json& own = value_at(rays, closed ? "against_closed_form" : "against_conoid");
      Case c{"ellipses",
             text_at(item, "id"),
             text_at(rays, "ray_model"),
             closed ? "relative difference of covariances, from the closed form"
                    : "relative difference of covariances, from the conoid",
             number_at(own, "relative_frobenius"),
             number_at(own, "z_max")};
      if (text_at(rays, "status") != "ok") c.status = Status::NoResult;
      cases.push_back(std::move(c));
    }
  }
  TestFamily family(case_family_level);
  for (const Case& c : cases)
    for (int i = 0; c.z && i < components; ++i) family.add(c.id, *c.z);
  const double threshold = family.two_sided_threshold();
  for (Case& c : cases)
    if (c.status == Status::Measured && c.z) c.status = std::abs(*c.z) > threshold ? Status::Differs : Status::Agrees;
}

void add_psfs(const Json& report, std::vector<Case>& cases) {
  for (const Json& psf : array_at(report, "psfs")) {
    const auto predicted = number_at(psf, "predicted/semi_axes_arcmin/0"),
               measured = number_at(psf, "measured/semi_axes_arcmin/0");
    std::optional<double> relative;
    if (predicted && measured && *predicted > 0.0) relative = std::abs(*measured / *predicted - 1.0);
    cases.push_back({"psfs", text_at(psf, "id"), text_at(psf, "ray_model"),
                     "relative difference of major axes, from the conoid", relative, std::nullopt,
                     relative ? Status::Measured : Status::NoResult});
  }
}

void add_images(const Json& report, std::vector<Case>& cases) {
  for (const Json& image : array_at(report, "images")) {
    const auto error = number_at(image, "metrics/rmse_linear"), floor = number_at(image, "noise_floor/rmse_linear");
    std::optional<double> ratio;
    if (error && floor && *floor > 0.0) ratio = *error / *floor;
    const Status status = !ratio ? Status::NoResult : *ratio > 1.0 ? Status::Differs : Status::Agrees;
    cases.push_back({"images", text_at(image, "id"), text_at(image, "ray_model"), "RMSE ÷ noise floor", ratio,
                     std::nullopt, status});
  }
}

std::vector<Case> cases_of(const Json& report) {
  std::vector<Case> cases;
  add_ellipses(report, cases);
  add_psfs(report, cases);
  add_images(report, cases);
  add_agreement_cases(report, cases);
  add_sampling_cases(report, cases);
  add_sin2_study_cases(report, cases);
  add_lens_study_cases(report, cases);
  for (Case& c : cases)
    for (const Json& gate : array_at(report, "gates"))
      if (decided(gate, c)) c.status = Status::Failed;
  std::stable_sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) {
    return a.status != b.status ? a.status < b.status : a.z.value_or(0.0) > b.z.value_or(0.0);
  });
  return cases;
}

Html table_of(const std::vector<Case>& cases) {
  HtmlTable table("All cases, failures first", "cases sortable filterable",
                  {{"Case"_html, false},
                   {"Status"_html, false},
                   {"Ray model, prediction or method"_html, false},
                   {"What is compared"_html, false},
                   {"Value"_html},
                   {"Largest |z| [σ]"_html}});
  for (const Case& c : cases) {
    const std::string status = name_of(c.status);
    const std::string css_class = c.status == Status::Failed ? "fail" : "";
    table.add_row({inline_element("a", {{"href", "#" + c.section}}, text_or_dash(c.id)),
                   Cell(text(status), static_cast<double>(c.status)),
                   code_html(c.ray_model),
                   text(c.measure),
                   {number_html(c.value, 3), c.value},
                   {number_html(c.z, 3), c.z}},
                  RowState{css_class, status});
  }
  return table.html();
}

}  // namespace

Html case_section(const Json& report) {
  const std::vector<Case> cases = cases_of(report);
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
