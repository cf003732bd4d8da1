#include "compare/findings/design_study.h"

#include "compare/studies/designs/design_findings.h"
#include "io/files/formatted_text.h"

namespace sturm {

namespace {

constexpr const char* median_share = "share of gazes that are blurred, median over wearers";
constexpr const char* largest_cylinder = "largest cylinder of the error as worn [D]";

std::string place_of(const DesignSummary& summary) {
  const bool far = !summary.distance_m || summary.distance_m->is_infinite();
  return summary.design + "|" + (far ? "inf" : plain_number(summary.distance_m->metres)) + " m";
}

Measurement measurement_of(const std::string& subject, const char* quantity, const Number& value) {
  return {.section = "design_study",
          .subject = subject,
          .quantity = quantity,
          .value = value,
          .better = Better::Less,
          .run_name = "design " + subject + ": " + quantity,
          .listed_as = value ? CaseStatus::Measured : CaseStatus::NoResult};
}

}  // namespace

void measure_design_study(const Json& report, Measurements& out) {
  const DesignFindings found = design_findings(report).value_or(DesignFindings{});
  for (const DesignFacts& design : found.designs)
    out.push_back(measurement_of(design.id, largest_cylinder, design.largest_cylinder_D));
  for (const DesignSummary& summary : design_summaries(found))
    out.push_back(measurement_of(place_of(summary), median_share, summary.median_share));
}

std::span<const StatisticRule> design_study_rules() {
  static constexpr StatisticRule rules[] = {
      {"design_max_median_share", "design_study", median_share, nullptr},
      {"design_max_cylinder", "design_study", largest_cylinder, nullptr},
  };
  return rules;
}

}  // namespace sturm
