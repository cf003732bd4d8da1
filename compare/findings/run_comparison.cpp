#include "compare/findings/run_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "compare/findings/sections.h"
#include "compare/gates/gate_result.h"
#include "compare/statistics/statistics.h"
#include "compare/statistics/test_family.h"
#include "compare/statistics/welch.h"
#include "io/json/stored.h"
#include "io/json/values.h"

namespace sturm {

namespace {

using Kind = RunChange::Kind;
using Direction = RunChange::Direction;

Direction direction_of(const Measurement& before, const Measurement& after) {
  const double a = *before.value, b = *after.value;
  switch (after.better) {
    case Better::Less:
      return b < a ? Direction::Better : Direction::Worse;
    case Better::More:
      return b > a ? Direction::Better : Direction::Worse;
    case Better::Nearer: {
      if (!before.target || !after.target) return Direction::Neither;
      const double was = std::abs(a - *before.target), is = std::abs(b - *after.target);
      return is < was ? Direction::Better : Direction::Worse;
    }
    case Better::Unknown:
      return Direction::Neither;
  }
  return Direction::Neither;
}

/// Whether a difference of the two can be held against standard errors.
bool testable(const Measurement& a, const Measurement& b) {
  return a.value && b.value && a.standard_error && b.standard_error &&
         std::hypot(*a.standard_error, *b.standard_error) > 0.0;
}

/// The change with its z, whether or not it means anything.
RunChange tested(const std::string& name, const Measurement& a, const Measurement& b) {
  const double va = *a.standard_error * *a.standard_error, vb = *b.standard_error * *b.standard_error;
  const double z = welch_z(*b.value - *a.value, {va, a.degrees}, {vb, b.degrees});
  return {name, Kind::BeyondUncertainty, direction_of(a, b), a.value, b.value, std::sqrt(va + vb), z};
}

/// The numbers that runs are compared by, by name. Times themselves and the values of gates, which are made of these
/// numbers, are not among them.
std::map<std::string, Measurement> compared_numbers(const Json& report) {
  std::map<std::string, Measurement> numbers;
  for (Measurement& m : measurements_of(report))
    if (!m.run_name.empty()) numbers.insert_or_assign(m.run_name, std::move(m));
  return numbers;
}

void compare_numbers(const Json& before, const Json& after, RunComparison& result) {
  const auto a = compared_numbers(before), b = compared_numbers(after);
  TestFamily family(result.level);
  std::vector<RunChange> candidates;
  for (const auto& [name, old] : a) {
    const auto found = b.find(name);
    if (found == b.end() || (old.value && !found->second.value)) {
      const bool by_chance = old.may_vanish && found != b.end();  // the case itself is still there
      if (old.value)
        result.changes.push_back({name, Kind::Missing, by_chance ? Direction::Neither : Direction::Worse, old.value,
                                  std::nullopt, std::nullopt, std::nullopt});
      continue;
    }
    const Measurement& now = found->second;
    if (!old.value || !now.value) continue;
    ++result.numbers;
    if (testable(old, now)) {
      candidates.push_back(tested(name, old, now));
      family.add(name, *candidates.back().z);
    } else if (old.bound && now.bound) {
      ++result.bounded;
      if (std::abs(*now.value - *old.value) > *old.bound + *now.bound)
        result.changes.push_back(
            {name, Kind::BeyondUncertainty, direction_of(old, now), old.value, now.value, std::nullopt, std::nullopt});
    } else if (*old.value != *now.value) {
      result.changes.push_back(
          {name, Kind::WithoutUncertainty, direction_of(old, now), old.value, now.value, std::nullopt, std::nullopt});
    }
  }
  for (const auto& [name, now] : b) {
    const auto found = a.find(name);
    if (now.value && (found == a.end() || !found->second.value))
      result.changes.push_back(
          {name, Kind::New, Direction::Neither, std::nullopt, now.value, std::nullopt, std::nullopt});
  }
  result.tests = family.tests();
  result.threshold_z = family.two_sided_threshold();
  for (const RunChange& c : candidates)
    if (std::abs(*c.z) > result.threshold_z) result.changes.push_back(c);
}

void compare_gates(const std::vector<GateResult>& before, const std::vector<GateResult>& after, RunComparison& result) {
  const auto find = [](const std::vector<GateResult>& gates, const std::string& id) -> const GateResult* {
    const auto found = std::find_if(gates.begin(), gates.end(), [&](const GateResult& g) { return g.id == id; });
    return found == gates.end() ? nullptr : &*found;
  };
  for (const GateResult& gate : before) {
    const GateResult* now = find(after, gate.id);
    RunChange change{"gate " + gate.id, Kind::Missing, Direction::Worse, gate.value,
                     std::nullopt,      std::nullopt,  std::nullopt};
    if (now) {
      if (gate.passed == now->passed) continue;
      change.kind = Kind::Verdict;
      change.direction = now->has_passed() ? Direction::Better : Direction::Worse;
      change.after = now->value;
    }
    result.changes.push_back(std::move(change));
  }
  for (const GateResult& gate : after) {
    if (find(before, gate.id)) continue;
    const bool passes = gate.has_passed();
    result.changes.push_back({"gate " + gate.id + (passes ? "" : ", which fails"), Kind::New,
                              passes ? Direction::Neither : Direction::Worse, std::nullopt, gate.value, std::nullopt,
                              std::nullopt});
  }
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::BeyondUncertainty:
      return "beyond_uncertainty";
    case Kind::WithoutUncertainty:
      return "without_uncertainty";
    case Kind::Verdict:
      return "verdict";
    case Kind::New:
      return "new";
    case Kind::Missing:
      return "missing";
  }
  return "";
}

const char* name_of(Direction direction) {
  return direction == Direction::Better ? "better" : direction == Direction::Worse ? "worse" : "neither";
}

Json run_json(const Json& report, const std::string& file) {
  return {{"file", file},
          {"title", text_at(report, "title")},
          {"commit", text_at(report, "provenance/commit")},
          {"seed", value_at(report, "provenance/seed")},
          {"started_utc", text_at(report, "provenance/started_utc")}};
}

}  // namespace

std::size_t RunComparison::regressions() const {
  return static_cast<std::size_t>(
      std::count_if(changes.begin(), changes.end(), [](const RunChange& c) { return c.is_regression(); }));
}

RunComparison compare_runs(const Json& before, const Json& after, double level) {
  RunComparison result;
  result.level = level;
  compare_numbers(before, after, result);
  compare_gates(read_gate_results(before), read_gate_results(after), result);
  const auto order = [](const RunChange& c) {
    return std::tuple(!c.is_regression(), static_cast<int>(c.kind), -std::abs(c.z.value_or(0.0)));
  };
  std::stable_sort(result.changes.begin(), result.changes.end(),
                   [&](const RunChange& a, const RunChange& b) { return order(a) < order(b); });
  return result;
}

std::string sentence_of(const RunComparison& comparison) {
  const auto count = [&](Kind kind) {
    return std::to_string(std::count_if(comparison.changes.begin(), comparison.changes.end(),
                                        [&](const RunChange& c) { return c.kind == kind; }));
  };
  return std::to_string(comparison.numbers) + " numbers compared, " + std::to_string(comparison.tests) +
         " with standard errors, " + std::to_string(comparison.bounded) +
         " with bounds: " + count(Kind::BeyondUncertainty) + " changed beyond uncertainty; " +
         count(Kind::WithoutUncertainty) + " of unknown uncertainty differ; " + count(Kind::Verdict) +
         " gates judge otherwise; " + count(Kind::New) + " new, " + count(Kind::Missing) + " missing; " +
         std::to_string(comparison.regressions()) + " worse.";
}

Json run_comparison_json(const RunComparison& comparison, const Json& before, const std::string& file_before,
                         const Json& after, const std::string& file_after) {
  Json changes = Json::array();
  for (const RunChange& c : comparison.changes)
    changes.push_back({{"name", c.name},
                       {"kind", name_of(c.kind)},
                       {"direction", name_of(c.direction)},
                       {"regression", c.is_regression()},
                       {"before", number_or_null(c.before)},
                       {"after", number_or_null(c.after)},
                       {"standard_error", number_or_null(c.standard_error)},
                       {"z", number_or_null(c.z)}});
  return {{"format", "sturm.run_comparison/1"},
          {"before", run_json(before, file_before)},
          {"after", run_json(after, file_after)},
          {"level", comparison.level},
          {"threshold_z", comparison.threshold_z},
          {"numbers", comparison.numbers},
          {"tests", comparison.tests},
          {"bounded", comparison.bounded},
          {"regressions", comparison.regressions()},
          {"sentence", sentence_of(comparison)},
          {"changes", std::move(changes)}};
}

}  // namespace sturm
