#include <gtest/gtest.h>

#include <string>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/readable_text.h"

namespace sturm {
namespace {

TEST(ReadableText, KeepsWhatIsText) {
  for (const char* text : {"", "plain", "grün", "−2.00 D", "日本", "😀"}) EXPECT_EQ(readable(text), text);
}

TEST(ReadableText, ReplacesIllFormedSequences) {
  EXPECT_EQ(readable("gr\xfcn"), "gr\uFFFDn");
  // The Unicode Standard 15.0, table 3-8: maximal subparts.
  EXPECT_EQ(readable("\x61\xF1\x80\x80\xE1\x80\xC2\x62\x80\x63\x80\xBF\x64"),
            "a\uFFFD\uFFFD\uFFFDb\uFFFDc\uFFFD\uFFFDd");
  EXPECT_EQ(readable("\xC0\xAF"), "\uFFFD\uFFFD");                      // overlong
  EXPECT_EQ(readable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");            // a surrogate
  EXPECT_EQ(readable("\xF4\x91\x92\x93"), "\uFFFD\uFFFD\uFFFD\uFFFD");  // beyond U+10FFFF
  EXPECT_EQ(readable("\xE2\x88"), "\uFFFD");                            // cut off
}

TEST(ReadableText, ShowsControlCharacters) {
  EXPECT_EQ(readable("a\nb\rc\td\x1b[31m\x7f"), "a\\nb\\rc\\td\\u001b[31m\\u007f");
  EXPECT_EQ(readable("\xC2\x9B"), "\\u009b");  // a control sequence in one character
  EXPECT_EQ(readable(std::string_view("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(readable_lines("a\nb\tc"), "a\nb\\tc");
  EXPECT_EQ(valid_utf8("a\nb\tc\xfc\x1b"), "a\nb\tc\uFFFD\x1b");
}

TEST(ReadableText, IsCutBetweenCharacters) {
  EXPECT_EQ(readable("日本語", 3), "日本語");
  EXPECT_EQ(readable("日本語", 2), "日…");
  EXPECT_EQ(readable("\xff\xff\xff\xff", 3), "\uFFFD\uFFFD…");
  EXPECT_EQ(readable("a\nb", 2), "a…");
  EXPECT_EQ(readable(std::string(1000000, 'x'), 5), "xxxx…");
}

TEST(InputError, IsOneLineOfText) {
  const InputError error("gr\xfcn.obj", "mat\terial", std::string(5000, '\xfc'), "x\ny");
  const std::string text = error.what();
  EXPECT_TRUE(text.starts_with("gr\uFFFDn.obj: mat\\terial: got \uFFFD")) << text;
  EXPECT_TRUE(text.ends_with("…, expected x\\ny")) << text;
  EXPECT_LT(text.size(), 800u);
}

TEST(FormattedText, HasAnyLength) {
  const std::string longer(3000, 'x');
  EXPECT_EQ(formatted("%s %d", longer.c_str(), 7), longer + " 7");
  EXPECT_EQ(formatted("%s", ""), "");
}

TEST(FormattedText, ExactNumbersCanBeToldFromTheirNeighbours) {
  EXPECT_EQ(exact_number(1.0000001f), "1.0000001");
  EXPECT_EQ(exact_number(0.1f), "0.1");
  EXPECT_EQ(exact_number(0.1), "0.1");
  EXPECT_EQ(exact_number(-2e-30), "-2e-30");
  EXPECT_EQ(exact_number(1.0 / 0.0), "inf");
  EXPECT_EQ(exact_number(-0.0 / 0.0), "nan");
}

}  // namespace
}  // namespace sturm
