#include "compare/findings/statistic_rule.h"

#include <map>

namespace sturm {

namespace {

bool is_meant(const StatisticRule& rule, const Measurement& m) {
  return m.section == rule.section && m.quantity == rule.quantity && (!rule.model || m.model == rule.model);
}

const std::string& case_of(const Measurement& m) {
  return m.worst_case.empty() ? m.subject : m.worst_case;
}

}  // namespace

void add_statistics(std::span<const StatisticRule> rules, const Measurements& measurements, Statistics& out) {
  for (const StatisticRule& rule : rules) {
    std::map<std::string, Extreme> extremes;
    if (rule.per == StatisticRule::Per::Report) extremes.try_emplace(rule.name, rule.of);
    for (const Measurement& m : measurements) {
      if (!is_meant(rule, m)) continue;
      const std::string name = rule.per == StatisticRule::Per::Model ? rule.name + ("/" + m.model) : rule.name;
      extremes.try_emplace(name, rule.of)
          .first->second.add(m.value, case_of(m), rule.with_error ? m.standard_error : std::nullopt);
    }
    for (const auto& [name, extreme] : extremes) out[name] = extreme.result();
  }
}

void add_statistics_by_themselves(const Measurements& measurements, Statistics& out) {
  for (const Measurement& m : measurements)
    if (!m.statistic.empty()) out[m.statistic] = {m.value, m.standard_error, m.cases, case_of(m), m.degrees};
}

StatisticSubject subject_of(std::string_view statistic, std::span<const StatisticRule> rules,
                            const Measurements& measurements) {
  for (const StatisticRule& rule : rules) {
    if (rule.per == StatisticRule::Per::Report && statistic == rule.name)
      return {rule.section, rule.model ? rule.model : ""};
    const std::string stem = std::string(rule.name) + "/";
    if (rule.per == StatisticRule::Per::Model && statistic.starts_with(stem))
      return {rule.section, std::string(statistic.substr(stem.size()))};
  }
  for (const Measurement& m : measurements)
    if (m.statistic == statistic) return {m.section, m.model};
  return {};
}

}  // namespace sturm
