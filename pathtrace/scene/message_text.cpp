#include "pathtrace/scene/message_text.h"

#include <array>
#include <charconv>
#include <cstddef>

namespace sturm {
namespace {

template <class Number>
std::string text_of(Number value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// Bytes of the UTF-8 character at the start of a text; 0 where there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80                      ? 1
                             : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                             : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                             : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                                 : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (length == 3 && (byte(0) == 0xE0 ? byte(1) < 0xA0 : byte(0) == 0xED && byte(1) >= 0xA0)) return 0;
  if (length == 4 && (byte(0) == 0xF0 ? byte(1) < 0x90 : byte(0) == 0xF4 && byte(1) >= 0x90)) return 0;
  return length;
}

}  // namespace

std::string shortest(float value) {
  return text_of(value);
}

std::string shortest(double value) {
  return text_of(value);
}

std::string in_quotes(std::string_view text) {
  constexpr int most_characters = 60;
  std::string shown = "\"";
  for (int count = 0; !text.empty(); ++count) {
    if (count == most_characters) return shown + "…\"";
    const std::size_t length = character_length(text);
    const bool printable = length > 1 || (length == 1 && text[0] >= ' ' && text[0] != '\x7F');
    shown += printable ? text.substr(0, length) : "?";
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown + "\"";
}

}  // namespace sturm
