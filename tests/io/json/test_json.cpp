#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "io/files/text_encoding.h"
#include "io/io_testing.h"
#include "io/json/json.h"
#include "io/json/json_pointer_set.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string parse_error(const std::string& text) {
  return input_error([&] { parse_json(text, "f.json"); });
}

TEST(Json, ReadsWhatIsValid) {
  const Json document =
      parse_json("\xEF\xBB\xBF {\"a\": [1, -2.5e3, \"x\", null, true]} ", "f.json");  // with byte-order mark
  EXPECT_EQ(document["a"][1], -2500.0);
  EXPECT_EQ(document["a"].size(), 5u);
}

TEST(Json, SyntaxErrorsNameLineAndColumn) {
  EXPECT_THAT(parse_error("{\n  \"a\": 1,\n  \"b\": }\n"), StartsWith("f.json:3:8: got syntax error"));
  EXPECT_THAT(parse_error("{\"a\": 1"), StartsWith("f.json:1:8: "));
  EXPECT_THAT(parse_error(""), StartsWith("f.json:1:1: "));
  EXPECT_THAT(parse_error("{\"a\": NaN}"), HasSubstr("f.json:1:7"));
  EXPECT_THAT(parse_error("{\"a\": 1} x"), HasSubstr("f.json:1:10"));
  EXPECT_THAT(parse_error("{'a': 1}"), HasSubstr("expected string literal"));
}

TEST(Json, DuplicateKeysAreRefusedWithTheirPlace) {
  EXPECT_EQ(parse_error("{\"a\": [0, {\"b/c\": 1, \"b/c\": 2}]}"),
            "f.json: /a/1/b~1c: got a second \"b/c\", expected each key at most once");
  EXPECT_NO_THROW(parse_json("[{\"a\": 1}, {\"a\": 2}, {\"b\": {\"a\": 3}, \"a\": 4}]", "f.json"));
}

TEST(Json, NumbersBeyondDoubleAndBrokenTextAreRefused) {
  EXPECT_THAT(parse_error("[1e999]"), AllOf(HasSubstr("1e999"), HasSubstr("f.json:1:")));
  EXPECT_THAT(parse_error("[\"\xff\"]"), HasSubstr("invalid"));
  EXPECT_THAT(parse_error(std::string(100, '[')), HasSubstr("64 nested"));
  EXPECT_NO_THROW(parse_json(std::string(64, '[') + std::string(64, ']'), "f.json"));
}

TEST(Json, FilesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(input_error([&] { load_json((folder / "none.json").string()); }),
              HasSubstr("none.json: got No such file"));
  EXPECT_THAT(input_error([&] { load_json(folder.path().string()); }), HasSubstr("got a folder"));
  write_text(folder / "a.json", "{\"a\": 1}");
  EXPECT_EQ(load_json((folder / "a.json").string())["a"], 1);
}

TEST(Json, CompactCutsLongValuesBetweenCharacters) {
  EXPECT_EQ(compact(Json{{"a", 1}}), "{\"a\":1}");
  EXPECT_EQ(compact(Json("ääää"), 6), "\"ää…");  // a quote and two letters of two bytes fit into 5 bytes
  EXPECT_LE(compact(Json(std::vector<int>(1000000, 7))).size(), 83u);
}

TEST(Json, PathsStartAtTheNamingFile) {
  EXPECT_EQ(path_beside("../b/x.obj", "/r/a/q.json"), "/r/b/x.obj");
  EXPECT_EQ(path_beside("/x.obj", "/r/a/q.json"), "/x.obj");
  EXPECT_EQ(path_beside("x.obj", "<stdin>"), std::filesystem::current_path() / "x.obj");
}

RC_GTEST_PROP(Json, WhatIsWrittenIsReadBack, (const std::map<std::string, std::vector<double>>& numbers)) {
  Json document = Json::object();
  for (const auto& [key, values] : numbers) {
    std::string ascii;
    for (const char c : key) ascii += static_cast<char>(c & 0x7f);
    document[ascii] = values;
  }
  RC_ASSERT(parse_json(document.dump(), "f.json") == document);
  RC_ASSERT(parse_json(document.dump(3), "f.json") == document);
}

RC_GTEST_PROP(Set, WritesExactlyThePlaceThatAPointerNames, (const std::vector<std::string>& words)) {
  Json document = Json::object();
  Source where{"f", ""};
  Json expected = 17;
  for (std::size_t i = words.size(); i-- > 0;) {
    std::string key;
    for (const char c : words[i])
      if ((c & 0x7f) != '=') key += static_cast<char>(c & 0x7f);
    where.pointer = (Source{"", ""} / key).pointer + where.pointer;
    expected = Json{{key, expected}};
  }
  if (words.empty()) return;
  apply_set(document, where.pointer + "=17");
  RC_ASSERT(document == expected);
}

TEST(Set, ReplacesAndCreates) {
  Json document = {{"eye", {{"pupil_diameter_mm", 4}}}, {"targets", {1, 2}}, {"spectacles", nullptr}};
  apply_set(document, "/eye/pupil_diameter_mm=5.5");
  apply_set(document, "/eye/accommodation/mode=relaxed");
  apply_set(document, "/targets/1={\"distance_m\": \"inf\"}");
  apply_set(document, "/targets/-=3");
  apply_set(document, "/text=a=b");
  apply_set(document, "/with~1slash~0=true");
  EXPECT_EQ(document["eye"]["pupil_diameter_mm"], 5.5);
  EXPECT_EQ(document["eye"]["accommodation"]["mode"], "relaxed");
  EXPECT_EQ(document["targets"], (Json{1, {{"distance_m", "inf"}}, 3}));
  EXPECT_EQ(document["text"], "a=b");
  EXPECT_EQ(document["with/slash~"], true);
}

TEST(Set, BadAssignmentsAreExplained) {
  Json document = {{"eye", "a.json"}, {"targets", {1, 2}}};
  const auto error = [&](const std::string& text) { return input_error([&] { apply_set(document, text); }); };
  EXPECT_EQ(error("seed=1"), "--set: got \"seed=1\", expected /pointer=value");
  EXPECT_EQ(error("/seed"), "--set: got \"/seed\", expected /pointer=value");
  EXPECT_EQ(error(""), "--set: got \"\", expected /pointer=value");
  EXPECT_THAT(error("/targets/2=1"), AllOf(HasSubstr("/targets"), HasSubstr("from 0 to 1")));
  EXPECT_THAT(error("/targets/x=1"), HasSubstr("index \"x\""));
  EXPECT_EQ(error("/eye/pupil_diameter_mm=1"),
            "--set: /eye: got \"a.json\", expected an object or array, to set \"pupil_diameter_mm\" in it");
  EXPECT_THAT(error("/a~2=1"), HasSubstr("~2"));
  EXPECT_THAT(error("/a=\xff"), HasSubstr("UTF-8"));
}

TEST(ParseJson, TypographicSignsAreNamedWhole) {
  const auto message = [](const std::string& text) { return input_error([&] { parse_json(text, "f.json"); }); };
  EXPECT_THAT(message("{\"a\": \u22121}"),
              AllOf(HasSubstr("f.json:1:7: got \"\u2212\""), HasSubstr("the \"-\" of the keyboard")));
  EXPECT_THAT(message("{\u201Ca\u201D: 1}"),
              AllOf(HasSubstr("got \"\u201C\""), HasSubstr("the quotes of the keyboard")));
  EXPECT_THAT(message("{\"a\": \U0001F453}"), HasSubstr("got \"\U0001F453\""));
  EXPECT_THAT(message("{\"a\": \xE9}"), HasSubstr("not UTF-8"));
  // A word of any length is cut, and between characters.
  const std::string long_text = message("{\"a\": \"" + std::string(500, 'a') + "\xE9\"}");
  EXPECT_LT(long_text.size(), 300u);
  EXPECT_TRUE(is_utf8(long_text)) << long_text;
}

}  // namespace
}  // namespace sturm
