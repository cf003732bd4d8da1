#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// Text made safe for element content and quoted attributes; control characters become U+FFFD.
std::string escaped(std::string_view text);

/// Escaped text, or "–" when it is empty.
std::string text_html(std::string_view text);

/// <tag attributes>inner</tag>; `attributes` and `inner_html` are HTML already.
std::string element(std::string_view tag, std::string_view attributes, std::string_view inner_html);

/// A link to a file of the run folder. Whatever is in the name is part of the path: no other scheme, query or fragment.
std::string file_link(std::string_view path);

/// Letters, digits and hyphens made of any text, for an id attribute; different texts may collide.
std::string slug(std::string_view text);

struct Column {
  std::string heading_html;  ///< with its unit
  bool numeric = true;       ///< right-aligned figures
};

struct Cell {
  std::string html;
  std::optional<double> order;  ///< what sorting compares instead of the text
  Cell(std::string html_, std::optional<double> order_ = std::nullopt) : html(std::move(html_)), order(order_) {}
  Cell(const char* html_) : html(html_) {}
};

/// What a filterable table knows of a row beside its text.
struct RowState {
  std::string css_class;  ///< of the row; "" = none
  std::string status;     ///< what the filter by state knows it by; "" = the row has no state
};

/// An HTML table with caption and scoped headers, in a frame that scrolls (also by keyboard) where the window is too
/// narrow.
class HtmlTable {
 public:
  /// `css_class` may hold "sortable" and "filterable"; `caption` is plain text.
  HtmlTable(std::string caption, std::string css_class, std::vector<Column> columns);

  /// One cell per column; the first one is the row's header.
  void add_row(const std::vector<Cell>& cells, std::string_view css_class = "");
  void add_row(const std::vector<Cell>& cells, const RowState& state);

  std::string html() const;

 private:
  std::string caption_, css_class_, rows_;
  std::vector<Column> columns_;
};

/// A part that starts folded unless `open`.
std::string folded(std::string_view summary_html, std::string_view inner_html, bool open = false);

}  // namespace sturm
