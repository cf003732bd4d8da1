#include <gtest/gtest.h>

#include "io/files/text_encoding.h"

using namespace std::string_literals;

namespace sturm {
namespace {

TEST(TextEncoding, IsToldFromTheBytes) {
  EXPECT_EQ(utf8_text("\xEF\xBB\xBFh\xC3\xA9"), "hé");
  EXPECT_EQ(utf8_text("h\xC3\xA9"), "hé");
  EXPECT_EQ(utf8_text("h\xE9"), "hé");                      // Latin-1
  EXPECT_EQ(utf8_text("\x80\x96\x9F\x81"), "€–Ÿ\uFFFD");    // Windows-1252; 81 stands for nothing
  EXPECT_EQ(utf8_text("\xFF\xFEh\0\xE9\0"s), "hé");         // UTF-16, little endian
  EXPECT_EQ(utf8_text("\xFE\xFF\0h\0\xE9"s), "hé");         // big endian
  EXPECT_EQ(utf8_text("h\0\xE9\0"s), "hé");                 // without a mark
  EXPECT_EQ(utf8_text("\0h\0\xE9"s), "hé");                 // big endian without a mark
  EXPECT_EQ(utf8_text("\xFF\xFE\x3D\xD8\x53\xDC"s), "👓");   // a pair of halves
  EXPECT_EQ(utf8_text("\xFF\xFE\x3D\xD8h\0"s), "\uFFFDh");  // half a pair
  EXPECT_EQ(utf8_text("\xFF\xFEh\0\xE9"s), "h");            // half a character at the end
}

TEST(TextEncoding, OtherBytesStay) {
  EXPECT_EQ(bytewise_text("h\xE9"), "h\xE9");
  EXPECT_EQ(bytewise_text("\xEF\xBB\xBFh\xE9"), "h\xE9");
  EXPECT_EQ(bytewise_text("\0h\0\xE9"s), "hé");
  EXPECT_EQ(bytewise_text("\0\0"s), "\0\0"s);
  EXPECT_EQ(bytewise_text("h"), "h");
}

TEST(TextEncoding, KnowsUtf8) {
  for (const char* text : {"", "abc", "é", "−", "👓", "\xED\x9F\xBF"}) EXPECT_TRUE(is_utf8(text)) << text;
  for (const char* text :
       {"\x80", "\xC3", "\xC0\x80", "\xE2\x88", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"})
    EXPECT_FALSE(is_utf8(text)) << text;
}

TEST(TextEncoding, SignsOfTheKeyboard) {
  EXPECT_EQ(with_keyboard_signs("−1 – 2\u00A0＋3 é"), "-1 - 2 +3 é");
}

}  // namespace
}  // namespace sturm
