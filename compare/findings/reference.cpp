#include "compare/findings/reference.h"

#include <initializer_list>
#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

/// The largest of some relative errors over all reference cases, as one measurement.
Measurement worst_of(const ReferenceFinding& finding, const char* statistic, std::initializer_list<const char*> names) {
  const std::uint64_t cases = finding.cases.value_or(0);
  Extreme worst;
  for (const char* name : names) {
    const auto error = finding.max_relative_error.find(name);
    if (cases >= 1) worst.add(error == finding.max_relative_error.end() ? std::nullopt : error->second, name);
  }
  return {.section = "reference",
          .quantity = "largest relative error",
          .value = worst.result().value,
          .cases = cases,
          .worst_case = worst.result().worst_case,
          .statistic = statistic};
}

}  // namespace

Json to_json(const ReferenceFinding& finding) {
  Json errors = Json::object();
  for (const auto& [quantity, error] : finding.max_relative_error) errors[quantity] = number_or_null(error);
  return {{"file", finding.file}, {"cases", count_or_null(finding.cases)}, {"max_relative_error", std::move(errors)}};
}

ReferenceFinding read_reference(const Json& report) {
  const Json& section = value_at(report, "reference");
  ReferenceFinding finding{
      .file = text_at(section, "file"), .cases = count_at(section, "cases"), .max_relative_error = {}};
  if (const Json& errors = value_at(section, "max_relative_error"); errors.is_object())
    for (const auto& [quantity, error] : errors.items()) finding.max_relative_error[quantity] = number_at(error, "");
  return finding;
}

void measure_reference(const Json& report, Measurements& out) {
  const ReferenceFinding finding = read_reference(report);
  out.push_back(worst_of(finding, "conoid_reference_max_relative_error", {"conoid_semi_axes", "conoid_covariance"}));
  out.push_back(worst_of(finding, "sin2_reference_max_relative_error", {"sin2_closed_form"}));
  for (const auto& [quantity, error] : finding.max_relative_error)
    out.push_back({.section = "reference",
                   .subject = quantity,
                   .quantity = "relative error",
                   .value = error,
                   .better = Better::Less,
                   .run_name = "reference: relative error of " + quantity});
}

}  // namespace sturm
