#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sturm {

/// Markup: a well-formed piece of HTML or SVG. No string turns into one by itself, so that text cannot be taken for
/// markup by mistake: text() escapes a string, element() and its kin make tags, and markup of the source is written as
/// a literal, "<i>so</i>"_html.
class Html {
 public:
  Html() = default;

  /// What others wrote and is well-formed: files that are compiled in, plots, JSON for the page's scripts. Taken as it
  /// is.
  static Html trusted(std::string markup) { return Html(std::move(markup)); }

  const std::string& markup() const { return markup_; }
  bool empty() const { return markup_.empty(); }

  Html& operator+=(const Html& more) {
    markup_ += more.markup_;
    return *this;
  }
  friend Html operator+(Html left, const Html& right) {
    left += right;
    return left;
  }
  friend bool operator==(const Html&, const Html&) = default;

 private:
  explicit Html(std::string markup) : markup_(std::move(markup)) {}

  std::string markup_;
};

/// Markup as it stands in the source.
inline Html operator""_html(const char* markup, std::size_t length) {
  return Html::trusted(std::string(markup, length));
}

/// The text itself, whatever is in it.
Html text(std::string_view text);

/// name="value"; the value is text and is escaped.
struct Attribute {
  std::string_view name;
  std::string value;
};
using Attributes = std::vector<Attribute>;

/// <tag attributes>inner</tag> and the end of the line.
Html element(std::string_view tag, const Attributes& attributes, const Html& inner);
Html element(std::string_view tag, const Html& inner);

/// The same within a line.
Html inline_element(std::string_view tag, const Attributes& attributes, const Html& inner);
Html inline_element(std::string_view tag, const Html& inner);

/// <tag attributes/>, within a line.
Html empty_element(std::string_view tag, const Attributes& attributes);

/// Appends `item` to `list`, behind `separator` unless it is the first.
void add_item(Html& list, const Html& item, const Html& separator = ", "_html);

}  // namespace sturm
