#include "io/files/text_encoding.h"

#include <array>
#include <cstdint>
#include <utility>

namespace sturm {

namespace {

using namespace std::string_view_literals;

constexpr std::uint32_t replacement_code = 0xFFFD;  // stands for what is no character

void append_utf8(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t bits) { text += static_cast<char>(bits); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)), byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

/// What Windows-1252 has from 0x80 to 0x9F, where Latin-1 has control characters; five bytes stand for nothing.
constexpr std::array<std::uint16_t, 32> windows_1252{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                     0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                                     0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                     0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::string from_windows_1252(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(text, byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80u] : byte);
  }
  return text;
}

std::string from_utf16(std::string_view bytes, bool little_endian) {
  const auto unit = [&](std::size_t at) {
    const auto low = static_cast<unsigned char>(bytes[at + (little_endian ? 0 : 1)]);
    const auto high = static_cast<unsigned char>(bytes[at + (little_endian ? 1 : 0)]);
    return static_cast<std::uint32_t>(high << 8 | low);
  };
  const auto is_low_surrogate = [](std::uint32_t code) { return code >= 0xDC00 && code < 0xE000; };
  std::string text;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code >= 0xD800 && code < 0xDC00 && at + 3 < bytes.size() && is_low_surrogate(unit(at + 2))) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(at + 2) - 0xDC00);
      at += 2;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = replacement_code;
    }
    append_utf8(text, code);
  }
  return text;
}

/// Number of bytes of the character at the start of `text`; 0 where there is none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t size = first < 0x80   ? 1
                           : first < 0xC2 ? 0
                           : first < 0xE0 ? 2
                           : first < 0xF0 ? 3
                           : first < 0xF5 ? 4
                                          : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (size > 2) {  // longer than needed, halves of UTF-16, beyond Unicode
    const unsigned second = byte(1);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || (first == 0xF0 && second < 0x90) ||
        (first == 0xF4 && second > 0x8F))
      return 0;
  }
  return size;
}

constexpr std::array<std::pair<std::string_view, char>, 17> keyboard_signs{{
    {"\u2212"sv, '-'},
    {"\u2010"sv, '-'},
    {"\u2011"sv, '-'},
    {"\u2012"sv, '-'},
    {"\u2013"sv, '-'},
    {"\u2014"sv, '-'},
    {"\uFE63"sv, '-'},
    {"\uFF0D"sv, '-'},
    {"\uFF0B"sv, '+'},
    {"\uFE62"sv, '+'},
    {"\u00A0"sv, ' '},
    {"\u202F"sv, ' '},
    {"\u2009"sv, ' '},
    {"\u2007"sv, ' '},
    {"\u2002"sv, ' '},
    {"\u2003"sv, ' '},
    {"\uFEFF"sv, ' '},
}};

}  // namespace

std::string bytewise_text(std::string bytes) {
  const std::string_view view = bytes;
  if (view.starts_with("\xFF\xFE")) return from_utf16(view.substr(2), true);
  if (view.starts_with("\xFE\xFF")) return from_utf16(view.substr(2), false);
  if (view.size() > 1 && (view[0] == '\0') != (view[1] == '\0')) return from_utf16(view, view[1] == '\0');
  if (view.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  return bytes;
}

std::string utf8_text(std::string bytes) {
  bytes = bytewise_text(std::move(bytes));
  return is_utf8(bytes) ? bytes : from_windows_1252(bytes);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string with_keyboard_signs(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::size_t size = 1;
    char sign = text[0];
    if (static_cast<unsigned char>(sign) >= 0x80)
      for (const auto& [typed, plain] : keyboard_signs)
        if (text.starts_with(typed)) size = typed.size(), sign = plain;
    result += sign;
    text.remove_prefix(size);
  }
  return result;
}

}  // namespace sturm
