#include "reports/markup/parts.h"

#include <cctype>
#include <cstdio>

namespace sturm {

Html absent_html() {
  return "–"_html;
}

Html text_or_dash(std::string_view words) {
  return words.empty() ? absent_html() : text(words);
}

Html code_html(std::string_view words) {
  return inline_element("code", text_or_dash(words));
}

Html small_html(const Html& remark) {
  return inline_element("small", remark);
}

Html unit_html(std::string_view unit) {
  return unit.empty() ? Html() : " "_html + text(unit);
}

Html mark_html(bool good, const Html& word) {
  return inline_element(good ? "span" : "strong", {{"class", good ? "mark pass" : "mark fail"}}, word);
}

Html fact(std::string_view name, const Html& known) {
  if (known.empty() || known == absent_html()) return {};
  return element("div", element("dt", text(name)) + element("dd", known));
}

Html fact_list(const Html& facts) {
  return element("dl", {{"class", "facts"}}, facts);
}

Html file_link(std::string_view path) {
  std::string address = "./";
  for (const char c : path) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '/' || c == '.' || c == '_' || c == '-') {
      address += c;
    } else {
      char encoded[4];
      std::snprintf(encoded, sizeof encoded, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
      address += encoded;
    }
  }
  return inline_element("a", {{"href", address}}, text(path));
}

std::string slug(std::string_view text) {
  std::string result;
  for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  return result;
}

Html folded(const Html& summary, const Html& inner, bool open) {
  return element("details", open ? Attributes{{"open", "open"}} : Attributes{}, element("summary", summary) + inner);
}

Html missing_html(const Html& why) {
  return element("p", {{"class", "missing"}}, why);
}

}  // namespace sturm
