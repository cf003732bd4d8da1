#pragma once
#include <string>
#include <string_view>

namespace sturm {

/// The bytes of a text file without a byte order mark, where UTF-16 has become UTF-8. It is known by its mark, or
/// without one by a first character of which one byte is 0.
std::string bytewise_text(std::string bytes);

/// The same as UTF-8: bytes that are not are taken as Windows-1252, which has all letters of Latin-1: what spreadsheets
/// of western Europe write.
std::string utf8_text(std::string bytes);

/// Whether every byte is part of a whole character of UTF-8.
bool is_utf8(std::string_view text);

/// The signs and blanks that word processors put in place of those of a keyboard as ASCII: U+2212 and dashes become -,
/// full-width signs + and -, non-breaking and thin spaces a blank.
std::string with_keyboard_signs(std::string_view text);

}  // namespace sturm
