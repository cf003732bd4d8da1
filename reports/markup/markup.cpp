#include "reports/markup/markup.h"

#include <cctype>
#include <cstdio>

#include "io/files/formatted_text.h"

namespace sturm {

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
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
        result += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') {
          result += "\uFFFD";
        } else {
          result += c;
        }
    }
  }
  return result;
}

std::string text_html(std::string_view text) {
  return text.empty() ? "–" : escaped(text);
}

std::string element(std::string_view tag, std::string_view attributes, std::string_view inner_html) {
  std::string result = "<";
  result.append(tag);
  if (!attributes.empty()) result.append(" ").append(attributes);
  return result.append(">").append(inner_html).append("</").append(tag).append(">\n");
}

std::string file_link(std::string_view path) {
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
  return "<a href=\"" + address + "\">" + escaped(path) + "</a>";
}

std::string slug(std::string_view text) {
  std::string result;
  for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  return result;
}

HtmlTable::HtmlTable(std::string caption, std::string css_class, std::vector<Column> columns)
    : caption_(std::move(caption)), css_class_(std::move(css_class)), columns_(std::move(columns)) {}

void HtmlTable::add_row(const std::vector<Cell>& cells, std::string_view css_class) {
  add_row(cells, RowState{std::string(css_class), ""});
}

void HtmlTable::add_row(const std::vector<Cell>& cells, const RowState& state) {
  rows_ += "<tr";
  if (!state.css_class.empty()) rows_ += " class=\"" + state.css_class + "\"";
  if (!state.status.empty()) rows_ += " data-status=\"" + escaped(state.status) + "\"";
  rows_ += ">";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool numeric = columns_.at(i).numeric;
    rows_ += i == 0 ? "<th scope=\"row\"" : "<td";
    if (numeric) rows_ += " class=\"n\"";
    if (cells[i].order) rows_ += " data-order=\"" + plain_number(*cells[i].order, 9) + "\"";
    rows_ += ">" + cells[i].html + (i == 0 ? "</th>" : "</td>");
  }
  rows_ += "</tr>\n";
}

std::string HtmlTable::html() const {
  std::string head;
  for (const Column& column : columns_) {
    head +=
        std::string("<th scope=\"col\"") + (column.numeric ? " class=\"n\"" : "") + ">" + column.heading_html + "</th>";
  }
  const std::string table = element("table", "class=\"" + css_class_ + "\"",
                                    element("caption", "", escaped(caption_)) +
                                        element("thead", "", element("tr", "", head)) + element("tbody", "", rows_));
  return element("div", "class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(caption_) + "\"",
                 table);
}

std::string folded(std::string_view summary_html, std::string_view inner_html, bool open) {
  return element("details", open ? "open=\"open\"" : "",
                 element("summary", "", summary_html) + std::string(inner_html));
}

}  // namespace sturm
