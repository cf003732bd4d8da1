#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/experiment/gate_kind.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

TEST(GateKinds, EachWordMeansOneKind) {
  for (const GateKindEntry& entry : gate_kinds) {
    EXPECT_EQ(&entry_of(entry.kind), &entry);
    EXPECT_EQ(gate_kind_in_file(entry.file_word), &entry) << entry.file_word;
    EXPECT_EQ(gate_kind_in_report(entry.report_word), &entry) << entry.report_word;
    EXPECT_FALSE(entry.sentence.empty()) << entry.file_word;
  }
  EXPECT_EQ(gate_kind_in_file("upper_bound"), nullptr);  // a word of reports
  EXPECT_EQ(gate_kind_in_report("at_most"), nullptr);
}

TEST(GateKinds, FilesMayNameThoseOfTheSchema) {
  const Json schema = load_json(std::string(STURM_SOURCE_DIR) + "/configs/schemas/gates.schema.json");
  std::vector<std::string> words;
  for (const GateKindEntry& entry : gate_kinds) words.emplace_back(entry.file_word);
  EXPECT_EQ(schema.at(Json::json_pointer("/properties/gates/items/properties/comparison/enum")), Json(words));
}

TEST(GateKinds, ARelationHoldsOnItsSideOfTheBound) {
  const auto below_at_above = [](Relation relation) {
    return std::vector<bool>{holds(relation, 1.0, 2.0), holds(relation, 2.0, 2.0), holds(relation, 3.0, 2.0)};
  };
  EXPECT_EQ(below_at_above(Relation::AtMost), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(below_at_above(Relation::AtLeast), (std::vector<bool>{false, true, true}));
  EXPECT_EQ(below_at_above(Relation::Above), (std::vector<bool>{false, false, true}));
}

}  // namespace
}  // namespace sturm
