#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "io/json/readable_json.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

TEST(ReadableJson, ShortThingsStayOnOneLine) {
  EXPECT_EQ(readable_json(Json{{"a", {1, 2.5, nullptr}}, {"b", {{"c", "x"}}}}),
            R"({"a": [1, 2.5, null], "b": {"c": "x"}})");
  EXPECT_EQ(readable_json(Json::object()), "{}");
  EXPECT_EQ(readable_json(Json(0.1)), "0.1");
}

TEST(ReadableJson, LongThingsAreBroken) {
  const std::string word(60, 'w');
  EXPECT_EQ(readable_json(Json{{"a", {{"k", word}}}, {"b", {word, word}}}),
            "{\n \"a\": {\"k\": \"" + word + "\"},\n \"b\": [\n  \"" + word + "\",\n  \"" + word + "\"\n ]\n}");
}

TEST(ReadableJson, ListsOfNumbersFillLines) {
  Json numbers = Json::array();
  for (int i = 0; i < 100; ++i) numbers.push_back(1000 + i);
  std::istringstream text(readable_json(numbers));
  std::size_t lines = 0;
  for (std::string line; std::getline(text, line); ++lines) EXPECT_LE(line.size(), 120u);
  EXPECT_EQ(lines, 2u + 5u);  // brackets alone, and 20 numbers of 4 digits with comma and blank on 120 characters
}

TEST(ReadableJson, MembersShareLinesAndObjectsDoNot) {
  const std::string word(70, 'w');
  EXPECT_EQ(readable_json(Json{{"a", 1}, {"b", {2, 3}}, {"c", {{"x", 1}}}, {"d", 4}, {"e", word}}),
            "{\n \"a\": 1, \"b\": [2, 3],\n \"c\": {\"x\": 1},\n \"d\": 4, \"e\": \"" + word + "\"\n}");
}

Json drawn(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 6 : 4);
  if (kind == 0) return *rc::gen::arbitrary<double>();
  if (kind == 1) return *rc::gen::string<std::string>();
  if (kind == 2) return *rc::gen::arbitrary<bool>();
  if (kind == 3) return nullptr;
  Json value = kind == 4 ? Json::array() : Json::object();
  for (int i = *rc::gen::inRange(0, 9); i > 0; --i)
    if (kind == 4)
      value.push_back(drawn(depth - 1));
    else
      value["key" + std::to_string(i)] = drawn(depth - 1);
  return value;
}

RC_GTEST_PROP(ReadableJson, SaysTheSameAsPlainJson, ()) {
  const Json value = drawn(4);
  const std::string plain = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  RC_ASSERT(Json::parse(readable_json(value)) == Json::parse(plain));
}

}  // namespace
}  // namespace sturm
