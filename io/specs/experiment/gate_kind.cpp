#include "io/specs/experiment/gate_kind.h"

#include <algorithm>
#include <stdexcept>

namespace sturm {

namespace {

template <typename Value>
const GateKindEntry* find_kind(Value GateKindEntry::*member, const Value& wanted) {
  const auto found = std::ranges::find(gate_kinds, wanted, member);
  return found == gate_kinds.end() ? nullptr : &*found;
}

}  // namespace

bool holds(Relation relation, double value, double bound) {
  switch (relation) {
    case Relation::AtMost:
      return value <= bound;
    case Relation::AtLeast:
      return value >= bound;
    case Relation::Above:
      return value > bound;
  }
  return false;
}

std::string_view sign_of(Relation relation) {
  constexpr std::string_view signs[] = {"≤", "≥", ">"};
  return signs[static_cast<int>(relation)];
}

const GateKindEntry& entry_of(GateKind kind) {
  if (const GateKindEntry* entry = find_kind(&GateKindEntry::kind, kind)) return *entry;
  throw std::logic_error("a kind of gate is missing in their table");
}

const GateKindEntry* gate_kind_in_file(std::string_view word) {
  return find_kind(&GateKindEntry::file_word, word);
}

const GateKindEntry* gate_kind_in_report(std::string_view word) {
  return find_kind(&GateKindEntry::report_word, word);
}

}  // namespace sturm
