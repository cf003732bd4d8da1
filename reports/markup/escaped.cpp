#include "reports/markup/escaped.h"

#include "io/files/readable_text.h"

namespace sturm {

namespace {

constexpr const char* replacement_character = "\uFFFD";

/// A tab, line feed or carriage return.
std::string white_space(char c, Dialect dialect) {
  if (dialect == Dialect::Xml) return "&#" + std::to_string(static_cast<int>(c)) + ";";
  return c == '\r' ? replacement_character : std::string(1, c);
}

}  // namespace

std::string escaped(std::string_view text, Dialect dialect) {
  std::string result;
  result.reserve(text.size());
  for (const char c : valid_utf8(text)) {  // names of files need not be text
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += dialect == Dialect::Xml ? "&apos;" : "&#39;";
        break;
      case '\t':
      case '\n':
      case '\r':
        result += white_space(c, dialect);
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20)
          result += replacement_character;
        else
          result += c;
    }
  }
  return result;
}

}  // namespace sturm
