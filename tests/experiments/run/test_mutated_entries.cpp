#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/run/mutated_entries.h"

namespace sturm {
namespace {

/// Two entries as a step keeps them: the first under two mutations, the second under none.
Json kept() {
  Json entries = {{{"id", "a"}, {"value", 1}, {"note", "honest"}}, {{"id", "b"}, {"value", 2}}};
  entries[0]["mutated"]["long"] = {{"id", "a"}, {"value", 30}};
  entries[0]["mutated"]["moved"] = {{"id", "a"}, {"value", 4}, {"note", "moved"}};
  return entries;
}

TEST(MutatedEntries, AReportHasTheHonestOnes) {
  EXPECT_EQ(honest_entries(kept()),
            (Json{{{"id", "a"}, {"value", 1}, {"note", "honest"}}, {{"id", "b"}, {"value", 2}}}));
  EXPECT_EQ(honest_entries(Json::array()), Json::array());
}

TEST(MutatedEntries, AMutationPutsWholeEntriesInTheirPlace) {
  EXPECT_EQ(mutated_entries(kept(), "long"), (Json{{{"id", "a"}, {"value", 30}}, {{"id", "b"}, {"value", 2}}}));
  EXPECT_EQ(mutated_entries(kept(), "moved")[0]["note"], "moved");
  EXPECT_EQ(mutated_entries(kept(), "unheard of"), honest_entries(kept()));
}

}  // namespace
}  // namespace sturm
