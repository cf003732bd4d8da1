#include "experiments/toy_study/toy_findings.h"

#include <cmath>

#include "io/files/formatted_text.h"
#include "io/json/record.h"

namespace sturm {

namespace {

constexpr const char* deviation = "traced radius of the blur ÷ that of the formula, distance from 1";

}  // namespace

template <>
inline constexpr auto record_members<ToyEntry> =
    std::tuple{member("defocus_D", &ToyEntry::defocus_D), member("traced_arcmin", &ToyEntry::traced_arcmin),
               member("expected_arcmin", &ToyEntry::expected_arcmin)};

template <>
inline constexpr auto record_members<ToyFindings> =
    std::tuple{member("pupil_mm", &ToyFindings::pupil_mm), member("entries", &ToyFindings::entries)};

Json to_json(const ToyFindings& findings) {
  return json_from(findings);
}

std::optional<ToyFindings> toy_findings(const Json& report) {
  return record_from<std::optional<ToyFindings>>(value_at(report, "toy_study"));
}

void measure_toy_study(const Json& report, Measurements& out) {
  const ToyFindings found = toy_findings(report).value_or(ToyFindings{});
  for (const ToyEntry& entry : found.entries) {
    Measurement m{.section = "toy_study",
                  .subject = entry.defocus_D ? plain_number(*entry.defocus_D) + " D" : std::string(),
                  .model = "thin_lens",
                  .quantity = deviation,
                  .listed_as = CaseStatus::Measured};
    if (entry.traced_arcmin && entry.expected_arcmin && *entry.expected_arcmin > 0.0)
      m.value = std::abs(*entry.traced_arcmin / *entry.expected_arcmin - 1.0);
    m.run_name = "toy study, " + m.subject;
    out.push_back(std::move(m));
  }
}

std::span<const StatisticRule> toy_study_rules() {
  static constexpr StatisticRule rules[] = {{"toy_max_deviation", "toy_study", deviation, nullptr}};
  return rules;
}

}  // namespace sturm
