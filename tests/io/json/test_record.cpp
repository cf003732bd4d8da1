#include <gtest/gtest.h>

#include <limits>

#include "io/json/record.h"

namespace sturm {

namespace {

struct Leaf {
  std::string name{};
  std::optional<double> number{};

  bool operator==(const Leaf&) const = default;
};

struct Tree {
  bool flag = true;
  std::optional<bool> choice{};
  double plain = 7.0;
  Count count{};
  std::optional<std::string> text{};
  std::optional<StoredDistance> distance{};
  std::array<std::optional<double>, 2> pair{};
  std::vector<Leaf> leaves{};
  std::optional<Leaf> leaf{};
  std::map<std::string, std::optional<Leaf>> by_name{};

  bool operator==(const Tree&) const = default;
};

}  // namespace

template <>
inline constexpr auto record_members<Leaf> =
    std::tuple{member("name", &Leaf::name), member("number", &Leaf::number, IfEmpty::LeftOut)};

template <>
inline constexpr auto record_members<Tree> =
    std::tuple{member("flag", &Tree::flag),      member("choice", &Tree::choice), member("plain", &Tree::plain),
               member("count", &Tree::count),    member("text", &Tree::text),     member("distance", &Tree::distance),
               member("pair", &Tree::pair),      member("leaves", &Tree::leaves), member("leaf", &Tree::leaf),
               member("by_name", &Tree::by_name)};

namespace {

Tree full_tree() {
  Tree tree{.flag = false, .choice = true, .plain = 1.5, .count = 3, .text = "t", .distance = StoredDistance{0.5}};
  tree.pair = {0.1, std::nullopt};
  tree.leaves = {{"a", 2.0}, {"b", std::nullopt}};
  tree.leaf = Leaf{"c", 3.0};
  tree.by_name = {{"d", Leaf{"e", {}}}, {"f", std::nullopt}};
  return tree;
}

TEST(Record, ComesBackAsItWas) {
  const Tree tree = full_tree();
  EXPECT_EQ(record_from<Tree>(Json::parse(json_from(tree).dump())), tree);
  EXPECT_EQ(record_from<Tree>(json_from(Tree{})), Tree{});
}

TEST(Record, EmptyIsNullUnlessItIsLeftOut) {
  const Json json = json_from(full_tree());
  EXPECT_EQ(json["pair"].dump(), "[0.1,null]");
  EXPECT_EQ(json["leaves"].dump(), R"([{"name":"a","number":2.0},{"name":"b"}])");
  EXPECT_EQ(json["by_name"].dump(), R"({"d":{"name":"e"},"f":null})");
  EXPECT_TRUE(json_from(Tree{})["leaf"].is_null());
  EXPECT_TRUE(json_from(Tree{})["distance"].is_null());
}

TEST(Record, NumbersKeepTheirKind) {
  EXPECT_EQ(json_from(full_tree())["count"].dump(), "3");
  EXPECT_EQ(json_from(Tree{.plain = 3.0})["plain"].dump(), "3.0");
  EXPECT_TRUE(json_from(Tree{.plain = std::numeric_limits<double>::quiet_NaN()})["plain"].is_null());
  EXPECT_EQ(json_from(Tree{.distance = StoredDistance{}})["distance"], "inf");
  EXPECT_TRUE(record_from<Tree>({{"distance", "inf"}}).distance->is_infinite());
  EXPECT_FALSE(finite(record_from<Tree>({{"distance", "inf"}}).distance));
  EXPECT_EQ(finite(record_from<Tree>({{"distance", 2}}).distance), 2.0);
}

TEST(Record, WhateverIsMissingOrMistypedIsAbsent) {
  const Json wrong = {{"flag", "no"},   {"choice", 1},       {"plain", "much"},  {"count", 2.5},
                      {"text", 4},      {"distance", "far"}, {"pair", {"x", 2}}, {"leaves", 5},
                      {"leaf", "leaf"}, {"by_name", {1, 2}}};
  const Tree tree = record_from<Tree>(wrong);
  EXPECT_TRUE(tree.flag);
  EXPECT_EQ(tree.plain, 7.0);
  EXPECT_FALSE(tree.choice || tree.count || tree.text || tree.distance || tree.leaf);
  EXPECT_EQ(tree.pair[1], 2.0);
  EXPECT_FALSE(tree.pair[0]);
  EXPECT_TRUE(tree.leaves.empty() && tree.by_name.empty());
  EXPECT_EQ(record_from<Tree>(Json(3)), Tree{});
  EXPECT_FALSE(record_from<std::optional<Tree>>(Json(nullptr)));
  EXPECT_EQ(record_from<std::vector<Leaf>>(Json{nullptr, {{"name", "a"}}}), (std::vector<Leaf>{{}, {"a", {}}}));
}

}  // namespace
}  // namespace sturm
