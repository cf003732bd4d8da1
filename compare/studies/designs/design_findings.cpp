#include "compare/studies/designs/design_findings.h"

#include <algorithm>
#include <cmath>

#include "compare/statistics/median.h"

namespace sturm {

template <>
inline constexpr auto record_members<DesignFacts> =
    std::tuple{member("id", &DesignFacts::id),
               member("note", &DesignFacts::note),
               member("sphere_D", &DesignFacts::sphere_D),
               member("cylinder_D", &DesignFacts::cylinder_D),
               member("axis_deg", &DesignFacts::axis_deg),
               member("largest_mean_D", &DesignFacts::largest_mean_D),
               member("largest_cylinder_D", &DesignFacts::largest_cylinder_D),
               member("clear_area_percent", &DesignFacts::clear_area_percent),
               member("narrowest_deg", &DesignFacts::narrowest_deg),
               member("narrowest_elevation_deg", &DesignFacts::narrowest_elevation_deg)};

template <>
inline constexpr auto record_members<DesignWearer> = std::tuple{member("wearer", &DesignWearer::wearer),
                                                                member("design", &DesignWearer::design),
                                                                member("distance_m", &DesignWearer::distance_m),
                                                                member("sphere_D", &DesignWearer::sphere_D),
                                                                member("cylinder_D", &DesignWearer::cylinder_D),
                                                                member("axis_deg", &DesignWearer::axis_deg),
                                                                member("age_years", &DesignWearer::age_years),
                                                                member("amplitude_D", &DesignWearer::amplitude_D),
                                                                member("addition_D", &DesignWearer::addition_D),
                                                                member("gazes", &DesignWearer::gazes),
                                                                member("lost", &DesignWearer::lost),
                                                                member("share_blurred", &DesignWearer::share_blurred),
                                                                member("median_D", &DesignWearer::median_D),
                                                                member("largest_D", &DesignWearer::largest_D),
                                                                member("status", &DesignWearer::status)};

template <>
inline constexpr auto record_members<DesignConditions> =
    std::tuple{member("clear_D", &DesignConditions::clear_D),
               member("reach_deg", &DesignConditions::reach_deg),
               member("step_deg", &DesignConditions::step_deg),
               member("rotation_center_mm", &DesignConditions::rotation_center_mm),
               member("pupil_mm", &DesignConditions::pupil_mm),
               member("amplitude_D", &DesignConditions::amplitude_D)};

template <>
inline constexpr auto record_members<DesignFindings> =
    std::tuple{member("conditions", &DesignFindings::conditions), member("designs", &DesignFindings::designs),
               member("wearers", &DesignFindings::wearers)};

namespace {

/// The smallest of some numbers that at least nine in ten of them do not exceed.
Number ninth_decile(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.9 * static_cast<double>(values.size())));
  return values[rank - 1];
}

}  // namespace

Json to_json(const DesignFindings& findings) {
  return json_from(findings);
}

std::optional<DesignFindings> design_findings(const Json& report) {
  return record_from<std::optional<DesignFindings>>(value_at(report, "design_study"));
}

Json to_json(const DesignFacts& facts) {
  return json_from(facts);
}

DesignFacts design_facts_from(const Json& value) {
  return record_from<DesignFacts>(value);
}

Json to_json(const std::vector<DesignWearer>& wearers) {
  return json_from(wearers);
}

std::vector<DesignWearer> design_wearers_from(const Json& list) {
  return record_from<std::vector<DesignWearer>>(list);
}

std::vector<DesignSummary> design_summaries(const DesignFindings& findings) {
  struct Numbers {
    std::vector<double> shares, medians;
  };
  std::vector<DesignSummary> summaries;
  std::vector<Numbers> numbers;
  for (const DesignWearer& row : findings.wearers) {
    const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const DesignSummary& s) {
      return s.design == row.design && s.distance_m == row.distance_m;
    });
    const auto place = static_cast<std::size_t>(found - summaries.begin());
    if (found == summaries.end()) {
      summaries.push_back({.design = row.design, .distance_m = row.distance_m});
      numbers.emplace_back();
    }
    ++summaries[place].wearers;
    if (row.status != "ok") ++summaries[place].not_made;
    if (row.share_blurred) numbers[place].shares.push_back(*row.share_blurred);
    if (row.median_D) numbers[place].medians.push_back(*row.median_D);
  }
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    summaries[i].median_share = median(numbers[i].shares);
    summaries[i].ninth_decile_share = ninth_decile(numbers[i].shares);
    summaries[i].median_D = median(numbers[i].medians);
  }
  return summaries;
}

}  // namespace sturm
