#pragma once
#include <array>
#include <string_view>

namespace sturm {

/// What a gate asks of its statistic.
enum class GateKind {
  AtMost,
  AtLeast,
  Differs,   ///< two things that must not agree
  Baseline,  ///< the statistic is how far another one has fallen below the committed baseline; negative: it has risen
  MustFail,  ///< the statistic is computed from a mutated input
};

/// How a value stands to a bound.
enum class Relation { AtMost, AtLeast, Above };

bool holds(Relation relation, double value, double bound);

/// ≤, ≥ or >.
std::string_view sign_of(Relation relation);

/// All that is said of a kind of gate, in files and to readers.
struct GateKindEntry {
  GateKind kind;
  std::string_view file_word;    ///< "comparison" in a gates file
  std::string_view report_word;  ///< "kind" of a gate in a report
  Relation passing;              ///< of the statistic to the bound when the gate passes
  std::string_view sentence;     ///< plain text
};

inline constexpr std::array<GateKindEntry, 5> gate_kinds = {
    {{GateKind::AtMost, "at_most", "upper_bound", Relation::AtMost, "passes when the statistic is at most the bound"},
     {GateKind::AtLeast, "at_least", "lower_bound", Relation::AtLeast,
      "passes when the statistic is at least the bound"},
     {GateKind::Differs, "differs", "must_differ", Relation::AtLeast,
      "two things must not agree: passes when the statistic is at least the bound"},
     {GateKind::Baseline, "baseline", "baseline", Relation::AtMost,
      "passes when the statistic has fallen below the baseline by the bound at most; the value is its fall"},
     {GateKind::MustFail, "must_fail", "must_fail", Relation::Above,
      "an input is wrong on purpose: passes when the statistic is above the bound"}}};

const GateKindEntry& entry_of(GateKind kind);

/// The entry with this word; null if there is none.
const GateKindEntry* gate_kind_in_file(std::string_view word);
const GateKindEntry* gate_kind_in_report(std::string_view word);

}  // namespace sturm
