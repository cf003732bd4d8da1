#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace sturm {

/// The bytes of a text file as UTF-8 without a byte order mark: UTF-16 is known by its byte order mark, or by a
/// second byte 0; bytes that are
/// not UTF-8 are taken as Latin-1, which is what spreadsheets of western Europe write.
std::string utf8_text(std::string bytes);

/// Whether every byte is part of a whole character of UTF-8.
bool is_utf8(std::string_view text);

/// `text` (UTF-8) up to `bytes`, never cut within a character; "…" stands for what was cut off.
std::string shortened(std::string_view text, std::size_t bytes = 80);

/// The signs and blanks that word processors put in place of those of a keyboard as ASCII: U+2212 and dashes become -,
/// full-width signs + and -, non-breaking and thin spaces a blank.
std::string with_keyboard_signs(std::string_view text);

}  // namespace sturm
