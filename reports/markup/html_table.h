#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/markup/html.h"

namespace sturm {

struct Column {
  Html heading;         ///< with its unit
  bool numeric = true;  ///< right-aligned figures
};

struct Cell {
  Html html;
  std::optional<double> order;  ///< what sorting compares instead of the text
  Cell(Html html_, std::optional<double> order_ = std::nullopt) : html(std::move(html_)), order(order_) {}
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

  Html html() const;

 private:
  std::string caption_, css_class_;
  Html rows_;
  std::vector<Column> columns_;
};

}  // namespace sturm
