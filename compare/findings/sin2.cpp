#include "compare/findings/sin2.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Json json_of(const Sin2Case& c) {
  return {{"case", c.id},
          {"V1_D", number_or_null(c.high_D)},
          {"V2_D", number_or_null(c.low_D)},
          {"true_semi_axes_arcmin", pair_or_null(c.true_semi_axes_arcmin)},
          {"sin2_semi_axes_arcmin", pair_or_null(c.sin2_semi_axes_arcmin)},
          {"closed_form_semi_axes_arcmin", pair_or_null(c.closed_form_semi_axes_arcmin)},
          {"ratio_major", number_or_null(c.ratio_major)},
          {"ratio_minor", number_or_null(c.ratio_minor)}};
}

Sin2Case case_from(const Json& json) {
  return {.id = text_at(json, "case"),
          .high_D = number_at(json, "V1_D"),
          .low_D = number_at(json, "V2_D"),
          .true_semi_axes_arcmin = pair_at(json, "true_semi_axes_arcmin"),
          .sin2_semi_axes_arcmin = pair_at(json, "sin2_semi_axes_arcmin"),
          .closed_form_semi_axes_arcmin = pair_at(json, "closed_form_semi_axes_arcmin"),
          .ratio_major = number_at(json, "ratio_major"),
          .ratio_minor = number_at(json, "ratio_minor")};
}

std::optional<VarianceRatio> ratio_from(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  return VarianceRatio{.measured_median = number_at(json, "measured_median"),
                       .predicted = number_at(json, "predicted"),
                       .worst_deviation = number_at(json, "worst_deviation")};
}

}  // namespace

Json to_json(const Sin2Findings& findings) {
  Json table = Json::array();
  for (const Sin2Case& c : findings.table) table.push_back(json_of(c));
  Json json = {{"cases_with_cylinder", count_or_null(findings.cases_with_cylinder)},
               {"table", std::move(table)},
               {"ratio_of_difference_of_principal_variances", nullptr},
               {"lost_total_variance", nullptr}};
  if (const auto& ratio = findings.ratio)
    json["ratio_of_difference_of_principal_variances"] = {{"measured_median", number_or_null(ratio->measured_median)},
                                                          {"predicted", number_or_null(ratio->predicted)},
                                                          {"worst_deviation", number_or_null(ratio->worst_deviation)}};
  if (const Number& worst = findings.worst_deviation_of_lost_variance)
    json["lost_total_variance"] = {{"worst_deviation_relative", number_or_null(worst)}};
  return json;
}

std::optional<Sin2Findings> read_sin2(const Json& report) {
  const Json& section = value_at(report, "sin2");
  if (!section.is_object()) return std::nullopt;
  Sin2Findings findings{
      .cases_with_cylinder = count_at(section, "cases_with_cylinder"),
      .table = {},
      .ratio = ratio_from(value_at(section, "ratio_of_difference_of_principal_variances")),
      .worst_deviation_of_lost_variance = number_at(section, "lost_total_variance/worst_deviation_relative")};
  for (const Json& row : array_at(section, "table")) findings.table.push_back(case_from(row));
  return findings;
}

}  // namespace sturm
