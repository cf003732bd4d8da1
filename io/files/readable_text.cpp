#include "io/files/readable_text.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>

namespace sturm {

namespace {

constexpr const char *replacement = "\uFFFD", *ellipsis = "…";

/// What stands at the beginning of a text.
struct Character {
  std::size_t bytes = 1;
  bool valid = false;
  std::uint32_t code = 0;
};

/// The first character, or how many bytes form none together (Unicode 15.0, table 3-7).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, true, lead};
  const std::size_t length = lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (length == 0) return {};
  unsigned low = lead == 0xE0   ? 0xA0
                 : lead == 0xF0 ? 0x90
                                : 0x80,
           high = lead == 0xED   ? 0x9F
                  : lead == 0xF4 ? 0x8F
                                 : 0xBF;
  Character character{length, true, lead & (0xFFu >> (length + 1))};
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= text.size() || byte(i) < low || byte(i) > high) return {i, false, 0};
    character.code = character.code << 6 | (byte(i) & 0x3F);
    low = 0x80, high = 0xBF;
  }
  return character;
}

std::string escape(std::uint32_t control) {
  if (control == '\n') return "\\n";
  if (control == '\r') return "\\r";
  if (control == '\t') return "\\t";
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "\\u%04x", control);
  return text.data();
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// The text up to `most` characters; control characters that `keeps` does not keep are escaped.
template <class Keeps>
std::string made_readable(std::string_view text, std::size_t most, const Keeps& keeps) {
  std::string shown, cut;  // `cut` is what is shown if the text turns out to be too long
  std::size_t count = 0;
  while (!text.empty()) {
    const Character c = first_character(text);
    if (count + 1 == most) cut = shown;
    if (++count > most) return cut + ellipsis;
    if (!c.valid)
      shown += replacement;
    else if (is_control(c.code) && !keeps(c.code))
      shown += escape(c.code);
    else
      shown += text.substr(0, c.bytes);
    text.remove_prefix(c.bytes);
  }
  return shown;
}

}  // namespace

std::string readable(std::string_view text) {
  return readable(text, any_number);
}

std::string readable(std::string_view text, std::size_t characters) {
  return made_readable(text, characters, [](std::uint32_t) { return false; });
}

std::string readable_lines(std::string_view text) {
  return made_readable(text, any_number, [](std::uint32_t code) { return code == '\n'; });
}

std::string valid_utf8(std::string_view text) {
  return made_readable(text, any_number, [](std::uint32_t) { return true; });
}

}  // namespace sturm
