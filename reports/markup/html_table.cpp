#include "reports/markup/html_table.h"

#include "io/files/formatted_text.h"

namespace sturm {

HtmlTable::HtmlTable(std::string caption, std::string css_class, std::vector<Column> columns)
    : caption_(std::move(caption)), css_class_(std::move(css_class)), columns_(std::move(columns)) {}

void HtmlTable::add_row(const std::vector<Cell>& cells, std::string_view css_class) {
  add_row(cells, RowState{std::string(css_class), ""});
}

void HtmlTable::add_row(const std::vector<Cell>& cells, const RowState& state) {
  Html row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Attributes attributes;
    if (i == 0) attributes.push_back({"scope", "row"});
    if (columns_.at(i).numeric) attributes.push_back({"class", "n"});
    if (cells[i].order) attributes.push_back({"data-order", plain_number(*cells[i].order, 9)});
    row += inline_element(i == 0 ? "th" : "td", attributes, cells[i].html);
  }
  Attributes attributes;
  if (!state.css_class.empty()) attributes.push_back({"class", state.css_class});
  if (!state.status.empty()) attributes.push_back({"data-status", state.status});
  rows_ += element("tr", attributes, row);
}

Html HtmlTable::html() const {
  Html head;
  for (const Column& column : columns_) {
    Attributes attributes = {{"scope", "col"}};
    if (column.numeric) attributes.push_back({"class", "n"});
    head += inline_element("th", attributes, column.heading);
  }
  const Html table =
      element("table", {{"class", css_class_}},
              element("caption", text(caption_)) + element("thead", element("tr", head)) + element("tbody", rows_));
  return element("div", {{"class", "scroll"}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", caption_}}, table);
}

}  // namespace sturm
